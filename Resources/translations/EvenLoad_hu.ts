<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hu_HU" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A last pass along the walls takes what is left</source>
        <translation>Egy utolsó fogás a falak mentén leveszi, ami maradt</translation>
    </message>
    <message>
        <source>Arcs in the output (G2, G3); without, lines only</source>
        <translation>Ívek a kimenetben (G2, G3); enélkül csak egyenesek</translation>
    </message>
    <message>
        <source>Area over side step and feed, in s: the time if all were cut at the angle and the feed</source>
        <translation>Terület osztva az oldallépéssel és az előtolással, s: az idő, ha minden a szöggel és az előtolással lenne kimarva</translation>
    </message>
    <message>
        <source>Area that the tool could reach and did not clear</source>
        <translation>Terület, amelyet a szerszám elérhetett volna, de nem mart ki</translation>
    </message>
    <message>
        <source>Cap of the feed control; at first twice the tool controller&apos;s horizontal feed</source>
        <translation>Az előtolás-vezérlés felső határa; kezdetben a szerszámvezérlő vízszintes előtolásának kétszerese</translation>
    </message>
    <message>
        <source>Centre of the pre-drilled hole</source>
        <translation>Az előfúrt furat középpontja</translation>
    </message>
    <message>
        <source>Centre of the spiral; fitted unless it is set</source>
        <translation>A spirál középpontja; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Checks each computed path against the job&apos;s models and stock, and refuses one that cuts into a model, or comes down into material by a rapid or a plunge</source>
        <translation>Minden kiszámított pályát ellenőriz a feladat modelljeivel és nyersdarabjával, és elutasítja azt, amely a modellbe vág, vagy gyorsjáratban vagy függőlegesen anyagba megy</translation>
    </message>
    <message>
        <source>Clears only what the job&apos;s earlier operations leave</source>
        <translation>Csak azt marja ki, amit a feladat korábbi műveletei meghagynak</translation>
    </message>
    <message>
        <source>Cuts without a break, at all levels</source>
        <translation>Megszakítás nélküli fogások, minden szinten</translation>
    </message>
    <message>
        <source>Descent of helix and ramp against the level</source>
        <translation>A csigavonal és a rámpa lejtése a vízszinteshez</translation>
    </message>
    <message>
        <source>Diameter of the pre-drilled hole; there is no hole until it is set</source>
        <translation>Az előfúrt furat átmérője; amíg nincs megadva, nincs furat</translation>
    </message>
    <message>
        <source>Diameter of the tool centre&apos;s helix; at first 0.9 of the tool&apos;s, and less where that does not fit</source>
        <translation>A szerszámközéppont csigavonalának átmérője; kezdetben a szerszám 0.9-szerese, és kevesebb, ahol az nem fér el</translation>
    </message>
    <message>
        <source>Direction of the passes against the X axis, seen from above</source>
        <translation>A sorok iránya az X tengelyhez, felülnézetben</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes seen from above; the same as the cusp height on a level face: setting one sets the other</source>
        <translation>A szomszédos sorok távolsága felülnézetben; vízszintes felületen ugyanaz, mint a barázdamagasság: az egyik beállítja a másikat</translation>
    </message>
    <message>
        <source>Exponent of the first turn: 1 is an ellipse; fitted unless it is set</source>
        <translation>Az első menet kitevője: 1 ellipszis; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Exponent of the last turn: towards 0 corners grow sharper; fitted unless it is set</source>
        <translation>Az utolsó menet kitevője: 0 felé a sarkok élesednek; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Feed of links at depth over cleared ground; at first the tool controller&apos;s horizontal rapid feed</source>
        <translation>Az átkötések előtolása mélységben, kimart terület felett; kezdetben a szerszámvezérlő vízszintes gyorsjárata</translation>
    </message>
    <message>
        <source>First semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>A spirál utolsó menetének első féltengelye, a szerszámközépponté; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Format of this operation&apos;s properties</source>
        <translation>A művelet tulajdonságainak formátuma</translation>
    </message>
    <message>
        <source>Height of what a ball or a rounded corner leaves between two passes of a level face: setting it sets the stepover; 0 for a flat end mill, which leaves steps</source>
        <translation>Amit a gömb vagy a lekerekített sarok vízszintes felület két sora között hagy: beállítja a sortávot; sík végű marónál 0, mert lépcsőket hagy</translation>
    </message>
    <message>
        <source>How far links rise above the floor; never above the top</source>
        <translation>Mennyire emelkednek az átkötések a fenék fölé; sosem a tető fölé</translation>
    </message>
    <message>
        <source>How far the trochoid advances in each turn, along the longest slot; 0: no trochoid was repeated, see Report</source>
        <translation>Mennyit halad a trochoid fordulatonként a leghosszabb horonyban; 0: nem ismétlődött trochoid, lásd Report</translation>
    </message>
    <message>
        <source>How often the tool rises and comes down again</source>
        <translation>Hányszor emelkedik ki a szerszám, és merül be újra</translation>
    </message>
    <message>
        <source>How the first semi-axis comes from the first turn to the last: 2 to 20 shares of its change, from 0 to 1, at even steps, as 0; 0.1; 0.4; 1; evenly where it is empty</source>
        <translation>Hogyan jut az első féltengely az első menettől az utolsóig: változásának 2–20 hányada, 0-tól 1-ig, egyenletes lépésekben, például 0; 0.1; 0.4; 1; üresen egyenletesen</translation>
    </message>
    <message>
        <source>Largest distance of the output from the exact path; never into a wall</source>
        <translation>A kimenet legnagyobb eltérése a pontos pályától; sosem a falba</translation>
    </message>
    <message>
        <source>Largest engagement angle, mean over 0.1 mm</source>
        <translation>A legnagyobb átfogási szög, 0.1 mm-re átlagolva</translation>
    </message>
    <message>
        <source>Length of cuts and of ways along the surface</source>
        <translation>A fogások és a felület menti utak hossza</translation>
    </message>
    <message>
        <source>Names of the settings that no longer follow the tool or the geometry</source>
        <translation>Azon beállítások nevei, amelyek már nem követik a szerszámot vagy a geometriát</translation>
    </message>
    <message>
        <source>Of neighbouring passes, seen from above</source>
        <translation>A szomszédos soroké, felülnézetben</translation>
    </message>
    <message>
        <source>Of several regions: each down to its last level, or all level by level</source>
        <translation>Több területnél: mindegyiket az utolsó szintjéig, vagy az összeset szintenként</translation>
    </message>
    <message>
        <source>Of the first semi-axis against the X axis; fitted unless it is set</source>
        <translation>Az első féltengelyé az X tengelyhez; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Passes that were steered to find the shape of that trochoid; 0 for circles and cycloids, and where none was repeated</source>
        <translation>A trochoid alakjának megtalálásához vezérelt fogások; 0 köröknél és cikloisoknál, és ahol nem ismétlődött</translation>
    </message>
    <message>
        <source>Second semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>A spirál utolsó menetének második féltengelye, a szerszámközépponté; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Share of the pocket that the spiral clears, 0 to 1</source>
        <translation>A zseb spirállal kimart hányada, 0 és 1 között</translation>
    </message>
    <message>
        <source>Sides of the curve: 3 for a triangle, 4 for a square or a rectangle; fitted unless it is set</source>
        <translation>A görbe oldalai: 3 háromszöghöz, 4 négyzethez vagy téglalaphoz; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Target and limit of the tool&apos;s engagement angle, between 0 and 180 degrees</source>
        <translation>Az átfogási szög célja és határa, 0 és 180 fok között</translation>
    </message>
    <message>
        <source>The engagement angle as the side step of a straight cut, r (1 - cos angle): setting one sets the other</source>
        <translation>Az átfogási szög egyenes fogás oldallépéseként, r (1 - cos szög): az egyik beállítja a másikat</translation>
    </message>
    <message>
        <source>The largest step of a turn; fitted to the engagement angle unless it is set, and smaller where that demands it</source>
        <translation>Egy menet legnagyobb lépése; az átfogási szöghöz illesztett, amíg nincs megadva, és kisebb, ahol az megkívánja</translation>
    </message>
    <message>
        <source>The same of the exponent; evenly or late, as is quicker, where it is empty</source>
        <translation>Ugyanez a kitevőre; üresen egyenletesen vagy későn, amelyik gyorsabb</translation>
    </message>
    <message>
        <source>The same of the second semi-axis</source>
        <translation>Ugyanez a második féltengelyre</translation>
    </message>
    <message>
        <source>The trochoid&apos;s shape; the circular and the cycloid one reach the engagement angle only for a moment of each turn</source>
        <translation>A trochoid alakja; a körös és a cikloisos csak egy pillanatra éri el az átfogási szöget minden fordulatban</translation>
    </message>
    <message>
        <source>Time for cuts, links, entries and retracts, in s</source>
        <translation>Fogások, átkötések, bemerülések és visszahúzások ideje, s</translation>
    </message>
    <message>
        <source>Volume over time along the longest slot at its first depth, links and the passes along both walls included, entry and ends not, in mm3/min</source>
        <translation>Térfogat osztva az idővel a leghosszabb horonyban, első mélységén, az átkötésekkel és a két fal menti fogásokkal, bemerülés és végek nélkül, mm3/min</translation>
    </message>
    <message>
        <source>Volume that the path removes</source>
        <translation>A pálya által leválasztott térfogat</translation>
    </message>
    <message>
        <source>Ways at depth from cut to cut</source>
        <translation>Utak a mélységben fogástól fogásig</translation>
    </message>
    <message>
        <source>What has to lie on the picked faces while the tool cuts: the point where it touches, or its axis seen from above</source>
        <translation>Minek kell a kijelölt felületeken lennie, amíg a szerszám vág: az érintési pontnak, vagy a tengelynek felülnézetben</translation>
    </message>
    <message>
        <source>What is cut; only Constant force asks for it</source>
        <translation>Amit marnak; csak az állandó erőhöz kell</translation>
    </message>
    <message>
        <source>What is done where the width left for the tool&apos;s centre is under twice MinimumRadius</source>
        <translation>Mi történjen ott, ahol a szerszámközéppontnak maradó szélesség a legkisebb sugár kétszerese alatt van</translation>
    </message>
    <message>
        <source>What rest machining depends on: the job&apos;s operations before this one</source>
        <translation>Amitől a maradékmegmunkálás függ: a feladat e művelet előtti műveletei</translation>
    </message>
    <message>
        <source>What stays above FinalDepth</source>
        <translation>Ami a végső mélység felett marad</translation>
    </message>
    <message>
        <source>What stays at the walls</source>
        <translation>Ami a falakon marad</translation>
    </message>
    <message>
        <source>What stays on the whole part, measured across its surface</source>
        <translation>Ami az egész darabon marad, a felületre merőlegesen mérve</translation>
    </message>
    <message>
        <source>What stays the same where the engagement is below its target</source>
        <translation>Mi marad azonos ott, ahol az átfogás a célja alatt van</translation>
    </message>
    <message>
        <source>What the spiral does not reach: cleared at constant engagement, or left</source>
        <translation>Amit a spirál nem ér el: állandó átfogással kimarva vagy meghagyva</translation>
    </message>
    <message>
        <source>What was not done, where and why; the error of a failed operation</source>
        <translation>Mi nem készült el, hol és miért; a sikertelen művelet hibája</translation>
    </message>
    <message>
        <source>Where the feed control would change the feed so often that a program has more blocks per metre of path, it changes it less often, for up to 4 % more time, but not along repeated trochoids or with a least load: for controllers that take few blocks; 0: no limit</source>
        <translation>Ahol a vezérlés olyan gyakran változtatná az előtolást, hogy a programban méterenként több mondat lenne, ritkábban változtatja, legfeljebb 4 % többletidővel, de ismételt trochoidok mentén vagy legkisebb terhelésnél nem: kevés mondatot fogadó vezérlőkhöz; 0: nincs határ</translation>
    </message>
    <message>
        <source>Wherever the feed is below MaximumFeed, what the feed control holds is at least this share of its nominal value, as far as moves can be divided: less time, more blocks; 0 to 0.95</source>
        <translation>Ahol az előtolás a legnagyobb alatt van, a vezérelt érték legalább ekkora része a névlegesnek, amennyire a mozgások oszthatók: kevesebb idő, több mondat; 0 és 0.95 között</translation>
    </message>
    <message>
        <source>Which way the cutting edges meet the material, whichever way the spindle turns</source>
        <translation>Hogyan érik az élek az anyagot, bármerre forog is az orsó</translation>
    </message>
    <message>
        <source>Width of the slot round a sketch or edges, which are its centreline once this is set; faces have their own</source>
        <translation>A horony szélessége vázlat vagy élek körül, amelyek ekkor a középvonalai; a felületeknek saját szélességük van</translation>
    </message>
    <message>
        <source>Wished radius of roll-in and roll-out; at first 0.15 of the tool&apos;s diameter</source>
        <translation>A be- és kigördülés kívánt sugara; kezdetben a szerszámátmérő 0.15-szorosa</translation>
    </message>
    <message>
        <source>Wished smallest radius of the path; at first 0.15 of the tool&apos;s diameter</source>
        <translation>A pálya kívánt legkisebb sugara; kezdetben a szerszámátmérő 0.15-szorosa</translation>
    </message>
    <message>
        <source>Radius of the upright arcs by which the tool comes into a pass from the air, and leaves one; smaller where the part is in the way; at first 0.1 of the tool&apos;s diameter</source>
        <translation>A függőleges ívek sugara, amelyeken a szerszám a levegőből a sorra áll, és elhagyja azt; kisebb, ahol a darab útban van; kezdetben a szerszámátmérő 0.1-szerese</translation>
    </message>
    <message>
        <source>The tool first comes in over the open side that is nearest to this place</source>
        <translation>A szerszám először azon a nyitott oldalon át érkezik, amelyik ehhez a helyhez a legközelebb van</translation>
    </message>
    <message>
        <source>What is the same between all passes: their distance seen from above, or the height of what stands between them</source>
        <translation>Ami minden sor között azonos: felülnézeti távolságuk, vagy a köztük maradó barázda magassága</translation>
    </message>
    <message>
        <source>How far passes go on beyond the border of the faces, seen from above: along what goes on there or falls away, not up what rises</source>
        <translation>Mennyivel mennek tovább a sorok a felületek szélén túl, felülnézetben: ami ott folytatódik vagy lejt, annak mentén, ami emelkedik, arra nem fel</translation>
    </message>
    <message>
        <source>Parallel passes to and fro, or all in one direction with a way back over the part; passes along the outline of the faces, or a spiral round their middle, from the outside or from the inside on; or passes between two picked edges, from the shape of one to the other&apos;s, to and fro or all in one direction</source>
        <translation>Párhuzamos sorok oda-vissza, vagy mind egy irányban visszaúttal a darab felett; sorok a felületek körvonala mentén, vagy spirál a közepük körül, kívülről vagy belülről kezdve; vagy sorok két kiválasztott él között, az egyik alakjából a másikéba, oda-vissza vagy mind egy irányban</translation>
    </message>
    <message>
        <source>How the tool reaches its depth; Automatic: an open side, else a set hole, else a helix, else a ramp</source>
        <translation>Hogyan éri el a szerszám a mélységét; Automatikus: nyitott oldal, különben megadott furat, különben csigavonal, különben rámpa</translation>
    </message>
    <message>
        <source>Whether the open side over which the tool first comes in is chosen by a place</source>
        <translation>Egy hely válassza-e ki azt a nyitott oldalt, amelyen át a szerszám először érkezik</translation>
    </message>
    <message>
        <source>What stays the same along the cuts: the feed, or the mean thickness of a ball&apos;s chips</source>
        <translation>Mi marad állandó a forgácsolás során: az előtolás vagy a gömbvégű maró forgácsának átlagos vastagsága</translation>
    </message>
    <message>
        <source>What the cut before has left above the surface that is made, across it: the feed control&apos;s chips are of that; at first 0.03 of the tool&apos;s diameter</source>
        <translation>Amit az előző megmunkálás a készülő felület fölött hagyott, arra merőlegesen: az előtolás-szabályozás forgácsai ebből vannak; kezdetben a szerszámátmérő 0,03-szorosa</translation>
    </message>
    <message>
        <source>Clamps, vices and other objects that the tool keeps off, as from above: what lies below them is not cut. The button takes what is selected</source>
        <translation>Szorítók, satuk és más objektumok, amelyeket a szerszám felülről elkerül: ami alattuk van, azt nem forgácsolja. A gomb a kijelölt objektumokat veszi át</translation>
    </message>
    <message>
        <source>How far the tool stays off the fixtures, all around</source>
        <translation>Milyen távol marad a szerszám a befogóeszközöktől, körös-körül</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one, the surface&apos;s triangles included; into the part usually a third of it, at the most half</source>
        <translation>A pálya legnagyobb eltérése a pontostól, a felület háromszögeivel együtt; a darabba általában ennek harmada, legfeljebb a fele</translation>
    </message>
</context>
<context>
    <name>EvenLoad</name>
    <message>
        <source> (%.2f of the ideal)</source>
        <translation> (%.2f × ideális)</translation>
    </message>
    <message>
        <source> degrees</source>
        <translation> fok</translation>
    </message>
    <message>
        <source> up to %1 mm,</source>
        <translation> legfeljebb %1 mm-rel</translation>
    </message>
    <message>
        <source>%.1f Hz, %.2f %% damping, %.3g N/µm</source>
        <translation>%.1f Hz, %.2f %% csillapítás, %.3g N/µm</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 és %2 további</translation>
    </message>
    <message>
        <source>%1 and %2 others</source>
        <translation>%1 és %2 másik</translation>
    </message>
    <message>
        <source>%1 and %2 overlap: draw what they enclose together as one, or use two operations.</source>
        <translation>%1 és %2 átfed: rajzolja meg egyként, amit együtt bezárnak, vagy használjon két műveletet.</translation>
    </message>
    <message>
        <source>%1 and Edge%2 of %3</source>
        <translation>%1 és %3: Edge%2</translation>
    </message>
    <message>
        <source>%1 and Face%2 of %3</source>
        <translation>%1 és %3: Face%2</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 nem olvasható: %2.</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 fok</translation>
    </message>
    <message>
        <source>%1 does not say what its columns are: taken as %2.</source>
        <translation>%1 nem mondja meg, mik az oszlopai: %2 értelmezéssel olvasva.</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 él</translation>
    </message>
    <message>
        <source>%1 edges of %2</source>
        <translation>%2: %1 él</translation>
    </message>
    <message>
        <source>%1 encloses no area near (%2, %3): draw it as a closed curve of at least two pieces.</source>
        <translation>%1 nem zár be területet itt: (%2, %3): rajzolja zárt görbének, legalább két darabból.</translation>
    </message>
    <message>
        <source>%1 has a coordinate that is not a number, after the point near (%2, %3): draw this piece again.</source>
        <translation>%1: az egyik koordináta nem szám, a pont után itt: (%2, %3): rajzolja újra ezt a darabot.</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1: az egyik értéke nem szám.</translation>
    </message>
    <message>
        <source>%1 has no %2: give it one.</source>
        <translation>%1: nincs %2: adja meg.</translation>
    </message>
    <message>
        <source>%1 has no dataset 58, a function at nodal degrees of freedom.</source>
        <translation>%1: nincs 58-as adatkészlete, csomóponti szabadságfokok függvénye.</translation>
    </message>
    <message>
        <source>%1 has no file: give it one.</source>
        <translation>%1: nincs fájlja: adjon meg egyet.</translation>
    </message>
    <message>
        <source>%1 has no lines of frequency, real and imaginary part, or magnitude and phase.</source>
        <translation>%1: nincsenek sorai frekvenciával, valós és képzetes résszel, vagy nagysággal és fázissal.</translation>
    </message>
    <message>
        <source>%1 has no points: measure some.</source>
        <translation>%1: nincsenek pontjai: mérjen néhányat.</translation>
    </message>
    <message>
        <source>%1 has stock beyond %2 sides without a wall, the first %3</source>
        <translation>%1: nyersdarab van %2 fal nélküli oldalon túl, az első %3</translation>
    </message>
    <message>
        <source>%1 has stock beyond a side without a wall, %2</source>
        <translation>%1: nyersdarab van egy fal nélküli oldalon túl, %2</translation>
    </message>
    <message>
        <source>%1 has too few lines: at least four are needed.</source>
        <translation>%1: túl kevés sora van: legalább négy kell.</translation>
    </message>
    <message>
        <source>%1 is %2: give an object.</source>
        <translation>%1: %2: adjon meg objektumot.</translation>
    </message>
    <message>
        <source>%1 is %2: it %3.</source>
        <translation>%1: %2: %3.</translation>
    </message>
    <message>
        <source>%1 is a solid: pick faces of it, or a sketch.</source>
        <translation>%1 szilárdtest: jelölje ki felületeit vagy egy vázlatot.</translation>
    </message>
    <message>
        <source>%1 is no face: pick the faces that are to be finished.</source>
        <translation>%1 nem felület: jelölje ki a simítandó felületeket.</translation>
    </message>
    <message>
        <source>%1 is no text: export the points as CSV or DMIS.</source>
        <translation>%1 nem szöveg: exportálja a pontokat CSV vagy DMIS formában.</translation>
    </message>
    <message>
        <source>%1 is not closed: it ends near (%2, %3): join this end to its start at (%4, %5) in the sketch.</source>
        <translation>%1 nem zárt, vége itt: (%2, %3): kösse össze a vázlatban a kezdetével itt: (%4, %5).</translation>
    </message>
    <message>
        <source>%1 is not flat: pick a flat face parallel to XY.</source>
        <translation>%1 nem sík: jelöljön ki XY-nal párhuzamos sík felületet.</translation>
    </message>
    <message>
        <source>%1 is open, the centreline of a slot: set SlotWidth, or close it.</source>
        <translation>%1 nyitott, egy horony középvonala: adja meg: [SlotWidth], vagy zárja be.</translation>
    </message>
    <message>
        <source>%1 is tilted: pick a face parallel to XY.</source>
        <translation>%1 ferde: jelöljön ki XY-nal párhuzamos felületet.</translation>
    </message>
    <message>
        <source>%1 lies %2 mm below the underside of the stock: make the stock larger, or move it there.</source>
        <translation>%1 %2 mm-rel a nyersdarab alja alatt van: növelje meg a nyersdarabot, vagy helyezze oda.</translation>
    </message>
    <message>
        <source>%1 lies outside the stock: move it, or make the stock larger.</source>
        <translation>%1 a nyersdarabon kívül van: helyezze át, vagy növelje meg a nyersdarabot.</translation>
    </message>
    <message>
        <source>%1 lies partly under the model, near (%2, %3), and the rest of it could not be found (%4): draw what is to be cleared as a sketch.</source>
        <translation>%1 részben a modell alatt van, itt: (%2, %3), és a többi része nem volt meghatározható (%4): rajzolja meg vázlatként, amit ki kell marni.</translation>
    </message>
    <message>
        <source>%1 lies partly under the model, near (%2, %3): what is covered is left out.</source>
        <translation>%1 részben a modell alatt van, itt: (%2, %3): a fedett rész kimarad.</translation>
    </message>
    <message>
        <source>%1 lies wholly under the model, which stands above it near (%2, %3): no tool reaches it from above. Pick another face.</source>
        <translation>%1 teljesen a modell alatt van, amely fölötte áll itt: (%2, %3): felülről egy szerszám sem éri el. Válasszon másik felületet.</translation>
    </message>
    <message>
        <source>%1 looks down: pick a face that looks up.</source>
        <translation>%1 lefelé néz: jelöljön ki felfelé néző felületet.</translation>
    </message>
    <message>
        <source>%1 looks down: pick faces that look up, or turn the model.</source>
        <translation>%1 lefelé néz: jelöljön ki felfelé néző felületeket, vagy fordítsa el a modellt.</translation>
    </message>
    <message>
        <source>%1 must be 2 to 20 values that begin with 0, end with 1 and never fall, as 0, 0.1, 0.4, 1.</source>
        <translation>%1 2–20 érték legyen, amely 0-val kezdődik, 1-gyel végződik és sosem csökken, például 0, 0.1, 0.4, 1.</translation>
    </message>
    <message>
        <source>%1 must have either %2 or %3.</source>
        <translation>%1: vagy %2, vagy %3 kell hozzá.</translation>
    </message>
    <message>
        <source>%1 of %2 has a surface that FreeCAD does not tell: leave it out.</source>
        <translation>%2, %1: felületét a FreeCAD nem nevezi meg: hagyja el.</translation>
    </message>
    <message>
        <source>%1 of %2 is no face and no edge: pick a face or a sketch.</source>
        <translation>%2, %1: nem felület és nem él: jelöljön ki felületet vagy vázlatot.</translation>
    </message>
    <message>
        <source>%1 of %2 is no face: pick the faces that are measured.</source>
        <translation>%2, %1: nem felület: jelölje ki a mért felületeket.</translation>
    </message>
    <message>
        <source>%1 of %2 is of no model of the job: pick faces of %3.</source>
        <translation>%2, %1: nem tartozik a feladat modelljeihez: jelöljön ki felületet ezen: %3.</translation>
    </message>
    <message>
        <source>%1 of &apos;%2&apos; must be a list.</source>
        <translation>„%2”: %1 lista legyen.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be a number above 0, not %3.</source>
        <translation>„%2” gép: %1 0-nál nagyobb szám legyen, nem pedig %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be a number of 0 or more, not %3.</source>
        <translation>„%2” gép: %1 legalább 0 szám legyen, nem pedig %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be a whole number, not %3.</source>
        <translation>„%2” gép: %1 egész szám legyen, nem pedig %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be one number above 0, or one each for x, y and z, not %3.</source>
        <translation>„%2” gép: %1 0-nál nagyobb szám legyen, vagy egy-egy x, y és z számára, nem pedig %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be the largest, or the least and the largest, not %3.</source>
        <translation>„%2” gép: %1 a legnagyobb érték legyen, vagy a legkisebb és a legnagyobb, nem pedig %3.</translation>
    </message>
    <message>
        <source>%1 points fit any face by %2 free motions: measure %3 or more, or leave fewer free.</source>
        <translation>%1 pont bármely felületre illik %2 szabad mozgással: mérjen legalább %3 pontot, vagy hagyjon kevesebbet szabadon.</translation>
    </message>
    <message>
        <source>%1 stands upright: finishing comes from above; EvenLoad Adaptive cuts walls.</source>
        <translation>%1 függőleges: a simítás felülről jön; falat az EvenLoad adaptív mar.</translation>
    </message>
    <message>
        <source>%1: %2 cannot be %3.</source>
        <translation>%1: %2 nem lehet %3.</translation>
    </message>
    <message>
        <source>%1: %2 must be a number, not %3.</source>
        <translation>%1: %2 szám legyen, nem pedig %3.</translation>
    </message>
    <message>
        <source>%1: cut down to %2 mm.</source>
        <translation>%1: kimarva eddig: %2 mm.</translation>
    </message>
    <message>
        <source>%1: it is cleared no further than %2, for the ground there lies behind walls or belongs to another face or outline of the operation.</source>
        <translation>%1: nem mar tovább ennél: %2, mert az a terület falak mögött van, vagy a művelet másik felületéhez vagy körvonalához tartozik.</translation>
    </message>
    <message>
        <source>%1: it is cleared to the edge of the stock, up to %2 mm from the face.</source>
        <translation>%1: a nyersdarab széléig mar, a felülettől legfeljebb %2 mm-ig.</translation>
    </message>
    <message>
        <source>%1: it is cleared up to %2 mm from the face, and what lies further out stays.</source>
        <translation>%1: a felülettől legfeljebb %2 mm-ig mar, ami kijjebb van, megmarad.</translation>
    </message>
    <message>
        <source>%1: it is not cleared there, for it would meet what is cleared beyond %2.</source>
        <translation>%1: ott nem mar, mert összeérne azzal, amit ezen túl mar: %2.</translation>
    </message>
    <message>
        <source>%1: it is not cleared, for the ground there could not be found (%2).</source>
        <translation>%1: ott nem mar, mert a terület nem volt meghatározható (%2).</translation>
    </message>
    <message>
        <source>%1: nothing is to be cut down to %2 mm, for the cut begins at %3 mm; raise StartDepth, or take it out of the base geometry.</source>
        <translation>%1: %2 mm-ig nincs mit marni, mert a fogás %3 mm-nél kezdődik; növelje: [StartDepth], vagy vegye ki az alapgeometriából.</translation>
    </message>
    <message>
        <source>%1: there is no file &apos;%2&apos;.</source>
        <translation>%1: nincs „%2” nevű fájl.</translation>
    </message>
    <message>
        <source>%1: unknown key &apos;%2&apos;; known keys are %3.</source>
        <translation>%1: ismeretlen kulcs: „%2”; ismert: %3.</translation>
    </message>
    <message>
        <source>%d points</source>
        <translation>%d pont</translation>
    </message>
    <message>
        <source>%s takes numbers, as 0; 0.1; 0.4; 1.</source>
        <translation>%s számokat vár, például 0; 0.1; 0.4; 1.</translation>
    </message>
    <message>
        <source>%s was not created: %s</source>
        <translation>%s nem jött létre: %s</translation>
    </message>
    <message>
        <source>%s: the same tool controller.</source>
        <translation>%s: ugyanaz a szerszámvezérlő.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to no job: create it in one.</source>
        <translation>„%1” nem tartozik feladathoz: hozza létre egyben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to no job: put it into one.</source>
        <translation>„%1” nem tartozik feladathoz: tegye egybe.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cuts nothing: its StartDepth does not lie above its FinalDepth.</source>
        <translation>„%1” nem mar semmit: [StartDepth] nincs e fölött: [FinalDepth].</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no level cut, whose stability could be told.</source>
        <translation>„%1”: nincs vízszintes fogása, amelynek stabilitása megadható lenne.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no mode: give it modes, or tap_tests to fit them to.</source>
        <translation>„%1”: nincs módusa: adjon meg modes értéket, vagy tap_tests méréseket az illesztéshez.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no path to simulate: recompute it first.</source>
        <translation>„%1”: nincs szimulálható pályája: előbb számítsa újra.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no path: recompute it first.</source>
        <translation>„%1”: nincs pályája: előbb számítsa újra.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no shape: pick a face or a sketch.</source>
        <translation>„%1”: nincs alakja: jelöljön ki felületet vagy vázlatot.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no spindle speed: set the tool controller&apos;s.</source>
        <translation>„%1”: nincs fordulatszáma: állítsa be a szerszámvezérlőét.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a mesh without faces: make a solid of it (Part, Create Shape from Mesh) first.</source>
        <translation>„%1” felületek nélküli háló: előbb készítsen belőle szilárdtestet (Part, Alakzat létrehozása hálóból).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its tool is %2, which the simulator cannot follow.</source>
        <translation>„%1” kimarad: szerszáma %2, amelyet a szimulátor nem tud követni.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; works on %2, which is not of the model: what must stay is not known.</source>
        <translation>„%1” ezen dolgozik: %2, amely nem a modellé: nem ismert, minek kell megmaradnia.</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, which comes before &apos;%2&apos;, failed: mend it and recompute.</source>
        <translation>„%1”, amely „%2” előtt van, hibára futott: javítsa ki, és számítsa újra.</translation>
    </message>
    <message>
        <source>&apos;%s&apos; would send the tool more than 10 m beyond the stock, and its path was emptied: it does not suit &apos;%s&apos;.</source>
        <translation>„%s” több mint 10 m-rel a nyersdarabon túlra küldené a szerszámot, ezért a pályája törölve lett: nem illik ehhez: „%s”.</translation>
    </message>
    <message>
        <source>, Pattern %1 was not used</source>
        <translation>, nem lett használva: [Pattern] %1</translation>
    </message>
    <message>
        <source>, for SemiAxisA or SemiAxisB is set</source>
        <translation>, mert meg van adva: [SemiAxisA] vagy [SemiAxisB]</translation>
    </message>
    <message>
        <source>, shares of the nominal load</source>
        <translation> (a névleges terhelés hányada)</translation>
    </message>
    <message>
        <source>, too narrow for trochoids</source>
        <translation>, trochoidokhoz túl szűk</translation>
    </message>
    <message>
        <source>, up to %1 mm deep</source>
        <translation>, legfeljebb %1 mm mélyen</translation>
    </message>
    <message>
        <source>1 tooth</source>
        <translation>1 fog</translation>
    </message>
    <message>
        <source>1 tooth and a helix of %1 degrees</source>
        <translation>1 fog és %1 fokos horonyemelkedés</translation>
    </message>
    <message>
        <source>: the channel along its island, from which it begins, takes most of the rest</source>
        <translation>: a szigete menti csatorna, amelyből indul, elveszi a többi nagy részét</translation>
    </message>
    <message>
        <source>; %1 mm² stay uncut there</source>
        <translation>; ott %1 mm² kimaratlan marad</translation>
    </message>
    <message>
        <source>A constant force needs a material that resists: give it a force coefficient above 0.</source>
        <translation>Állandó erőhöz ellenálló anyag kell: adjon neki 0-nál nagyobb erőtényezőt.</translation>
    </message>
    <message>
        <source>A constant force needs the spindle&apos;s speed: set that of the tool controller.</source>
        <translation>Állandó erőhöz fordulatszám kell: állítsa be a szerszámvezérlőét.</translation>
    </message>
    <message>
        <source>A file may be of more faces than these</source>
        <translation>A fájl más felületek pontjait is tartalmazhatja</translation>
    </message>
    <message>
        <source>A last pass along the walls takes what is left</source>
        <translation>Egy utolsó fogás a falak mentén leveszi, ami maradt</translation>
    </message>
    <message>
        <source>A machine is a name, a JSON file or a dictionary of limits, not %1.</source>
        <translation>A gép név, JSON-fájl vagy határok szótára, nem pedig %1.</translation>
    </message>
    <message>
        <source>A mode was found whose mass is not above 0: ask for fewer modes, or turn the sign of the response.</source>
        <translation>Olyan módus adódott, amelynek tömege nincs 0 felett: kérjen kevesebb módust, vagy fordítsa meg az átvitel előjelét.</translation>
    </message>
    <message>
        <source>A normal looks down: a probe from above cannot reach its point.</source>
        <translation>Egy normális lefelé mutat: felülről a tapintó nem éri el a pontját.</translation>
    </message>
    <message>
        <source>A point has a coordinate that is not a number: leave it out.</source>
        <translation>Egy pont koordinátája nem szám: hagyja el.</translation>
    </message>
    <message>
        <source>A region has no spiral: with narrow passages it is cleared at constant engagement; set NarrowPassages to &apos;Skip and report&apos; for a spiral.</source>
        <translation>Egy területnek nincs spirálja: szűk helyekkel állandó átfogással mar; spirálhoz állítsa be: [NarrowPassages]: „Kihagyás és jelentés”.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Új</translation>
    </message>
    <message>
        <source>Adds a mode</source>
        <translation>Módust ad hozzá</translation>
    </message>
    <message>
        <source>After %1 passes the trochoid&apos;s advance still differed by %2 mm across the slot: the greatest step was taken that keeps the engagement angle.</source>
        <translation>%1 fogás után a trochoid haladása a hornyon át még %2 mm-rel eltért: az átfogási szöget tartó legnagyobb lépés lett választva.</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Összevetés</translation>
    </message>
    <message>
        <source>All of the file</source>
        <translation>A fájl összes pontja</translation>
    </message>
    <message>
        <source>All points are nearer to other faces: pick those that were measured.</source>
        <translation>Minden pont más felületekhez van közelebb: jelölje ki a mérteket.</translation>
    </message>
    <message>
        <source>All points lie on one line: spread them over the faces.</source>
        <translation>Minden pont egy egyenesen van: ossza el őket a felületeken.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Felületi ráhagyás</translation>
    </message>
    <message>
        <source>An edge climbs by %1 mm: pick edges and sketches that are parallel to XY.</source>
        <translation>Egy él %1 mm-t emelkedik: jelöljön ki XY-nal párhuzamos éleket és vázlatokat.</translation>
    </message>
    <message>
        <source>An edge has no end: pick edges of finite length.</source>
        <translation>Egy élnek nincs vége: jelöljön ki véges hosszú éleket.</translation>
    </message>
    <message>
        <source>An island crosses or touches itself near (%1, %2): remove the crossing in the sketch.</source>
        <translation>Egy sziget metszi vagy érinti önmagát itt: (%1, %2): szüntesse meg a metszést a vázlatban.</translation>
    </message>
    <message>
        <source>An island lies inside another island near (%1, %2): remove the inner one, or make it a pocket of its own.</source>
        <translation>Egy sziget egy másikban van itt: (%1, %2): távolítsa el a belsőt, vagy tegye önálló zsebbé.</translation>
    </message>
    <message>
        <source>An island lies outside the outline near (%1, %2): move it inside or remove it.</source>
        <translation>Egy sziget a körvonalon kívül van itt: (%1, %2): helyezze belülre, vagy távolítsa el.</translation>
    </message>
    <message>
        <source>Another one beside it on the same scale; each as if the other had cut nothing</source>
        <translation>Egy másik mellette azonos léptékben; mindegyik úgy, mintha a másik nem vágott volna</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Alkalmaz</translation>
    </message>
    <message>
        <source>Arc length</source>
        <translation>Ívhossz</translation>
    </message>
    <message>
        <source>Arcs (G2, G3)</source>
        <translation>Ívek (G2, G3)</translation>
    </message>
    <message>
        <source>Arcs in the output (G2, G3); without, lines only</source>
        <translation>Ívek a kimenetben (G2, G3); enélkül csak egyenesek</translation>
    </message>
    <message>
        <source>Area that the tool could reach and did not clear</source>
        <translation>Terület, amelyet a szerszám elérhetett volna, de nem mart ki</translation>
    </message>
    <message>
        <source>As a click into the chart sets it</source>
        <translation>Ahogy a diagramba kattintva beállítja</translation>
    </message>
    <message>
        <source>As seen from above</source>
        <translation>Felülnézetben</translation>
    </message>
    <message>
        <source>At a constant feed the uneven turns of this spiral are slow: the feed control &apos;Constant removal rate&apos; or the operation Adaptive is faster.</source>
        <translation>Állandó előtolással e spirál egyenetlen menetei lassúak: az „Áll. anyagleválasztás” előtolás-vezérlés vagy az adaptív művelet gyorsabb.</translation>
    </message>
    <message>
        <source>At least one mode must be fitted.</source>
        <translation>Legalább egy módust illeszteni kell.</translation>
    </message>
    <message>
        <source>At least so many; fewer than 49 may tell too little</source>
        <translation>Legalább ennyi; 49-nél kevesebb túl keveset mondhat</translation>
    </message>
    <message>
        <source>At, °</source>
        <translation>Irány, °</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatikus</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Gömbsugár</translation>
    </message>
    <message>
        <source>Below %1 Hz the integration of the acceleration drifts: leave these lines out.</source>
        <translation>%1 Hz alatt a gyorsulás integrálása elcsúszik: hagyja el ezeket a sorokat.</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Legjobb keresése</translation>
    </message>
    <message>
        <source>Best cut</source>
        <translation>Legjobb fogás</translation>
    </message>
    <message>
        <source>By minimum zone, with its proof</source>
        <translation>Minimális zónával, bizonyítással</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Mégse</translation>
    </message>
    <message>
        <source>Cancelled before everything was cut.</source>
        <translation>Megszakítva, mielőtt minden ki lett volna marva.</translation>
    </message>
    <message>
        <source>Cancelled before everything was cut: there is no path until it is computed again.</source>
        <translation>Megszakítva, mielőtt minden ki lett volna marva: nincs pálya, amíg újra nem számítják.</translation>
    </message>
    <message>
        <source>Cap of the feed control; at first twice the tool controller&apos;s horizontal feed</source>
        <translation>Az előtolás-vezérlés felső határa; kezdetben a szerszámvezérlő vízszintes előtolásának kétszerese</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Középpont</translation>
    </message>
    <message>
        <source>Centre must be finite.</source>
        <translation>[Centre] véges legyen.</translation>
    </message>
    <message>
        <source>Centre of the pre-drilled hole</source>
        <translation>Az előfúrt furat középpontja</translation>
    </message>
    <message>
        <source>Centre of the spiral; fitted unless it is set</source>
        <translation>A spirál középpontja; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Changed: Apply computes the path</source>
        <translation>Módosult: az Alkalmaz kiszámítja a pályát</translation>
    </message>
    <message>
        <source>Changed: computing the path</source>
        <translation>Módosult: a pálya számítása folyik</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagram</translation>
    </message>
    <message>
        <source>Check against the model</source>
        <translation>Ellenőrzés a modellel</translation>
    </message>
    <message>
        <source>Checked against the model.</source>
        <translation>A modellel ellenőrizve.</translation>
    </message>
    <message>
        <source>Checks each computed path against the job&apos;s models and stock, and refuses one that cuts into a model, or comes down into material by a rapid or a plunge</source>
        <translation>Minden kiszámított pályát ellenőriz a feladat modelljeivel és nyersdarabjával, és elutasítja azt, amely a modellbe vág, vagy gyorsjáratban vagy függőlegesen anyagba megy</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Forgácsvastagság</translation>
    </message>
    <message>
        <source>Chips get up to %1 times as thick as in a straight cut at the engagement angle, %2: lower MaximumFeed, or choose another FeedControl, where that is too much.</source>
        <translation>A forgács akár %1-szer olyan vastag, mint egyenes fogásban az átfogási szöggel, %2: csökkentse: [MaximumFeed], vagy válasszon mást, ahol ez túl sok: [FeedControl].</translation>
    </message>
    <message>
        <source>Circular</source>
        <translation>Körös</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Kimarás</translation>
    </message>
    <message>
        <source>Clearance Height</source>
        <translation>Szabadonfutási magasság</translation>
    </message>
    <message>
        <source>ClearanceHeight (%1 mm) lies below SafeHeight (%2 mm): raise it.</source>
        <translation>[ClearanceHeight] (%1 mm) ez alatt van: [SafeHeight] (%2 mm): növelje.</translation>
    </message>
    <message>
        <source>Clears only what the job&apos;s earlier operations leave</source>
        <translation>Csak azt marja ki, amit a feladat korábbi műveletei meghagynak</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Egyenirányú</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Bezárás</translation>
    </message>
    <message>
        <source>Closes the window</source>
        <translation>Bezárja az ablakot</translation>
    </message>
    <message>
        <source>Colours the path in the 3D view by its load, or ends that</source>
        <translation>A pályát a 3D nézetben a terhelés szerint színezi, vagy befejezi ezt</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Oszlopok</translation>
    </message>
    <message>
        <source>Command %1 of the path, %2, %3</source>
        <translation>A pálya %1. parancsa, %2, %3</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Számítás</translation>
    </message>
    <message>
        <source>Computing the path</source>
        <translation>A pálya számítása</translation>
    </message>
    <message>
        <source>Constant chip thickness</source>
        <translation>Állandó forgácsvastagság</translation>
    </message>
    <message>
        <source>Constant cusp height</source>
        <translation>Állandó barázdamagasság</translation>
    </message>
    <message>
        <source>Constant engagement</source>
        <translation>Állandó átfogás</translation>
    </message>
    <message>
        <source>Constant feed</source>
        <translation>Állandó előtolás</translation>
    </message>
    <message>
        <source>Constant force</source>
        <translation>Állandó erő</translation>
    </message>
    <message>
        <source>Constant removal rate</source>
        <translation>Áll. anyagleválasztás</translation>
    </message>
    <message>
        <source>Constant stepover</source>
        <translation>Állandó sortáv</translation>
    </message>
    <message>
        <source>Contours inwards</source>
        <translation>Kontúrok befelé</translation>
    </message>
    <message>
        <source>Contours outwards</source>
        <translation>Kontúrok kifelé</translation>
    </message>
    <message>
        <source>Conventional</source>
        <translation>Ellenirányú</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Hűtés</translation>
    </message>
    <message>
        <source>Course of A</source>
        <translation>A lefutása</translation>
    </message>
    <message>
        <source>Course of B</source>
        <translation>B lefutása</translation>
    </message>
    <message>
        <source>Course of exponent</source>
        <translation>Kitevő lefutása</translation>
    </message>
    <message>
        <source>Create %s</source>
        <translation>%s létrehozása</translation>
    </message>
    <message>
        <source>Cusp height</source>
        <translation>Barázdamagasság</translation>
    </message>
    <message>
        <source>CuspHeight is %1 mm: it must lie between 0 and the %2 mm of the tool&apos;s radius at its end.</source>
        <translation>[CuspHeight]: %1 mm: 0 és a szerszám végének sugara, %2 mm közé essen.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Fogás</translation>
    </message>
    <message>
        <source>Cut at reduced feed</source>
        <translation>Csökkentett előtolással</translation>
    </message>
    <message>
        <source>Cut at reduced feed%1: the passage %2, %3 mm wide at its narrowest, with up to %4° engaged, down to %5 mm/min%6.</source>
        <translation>Csökkentett előtolással kimarva%1: a szűk hely %2, legkeskenyebb részén %3 mm széles, legfeljebb %4° átfogással, akár %5 mm/min előtolással%6.</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Marási irány</translation>
    </message>
    <message>
        <source>Cuts without a break</source>
        <translation>Megszakítás nélküli fogások</translation>
    </message>
    <message>
        <source>Cuts, links, entries and retracts at the path&apos;s own feeds</source>
        <translation>Fogások, átkötések, bemerülések és visszahúzások a pálya saját előtolásaival</translation>
    </message>
    <message>
        <source>Cuts, links, entries and retracts at the path&apos;s own feeds; Cycle Time is the same. The ideal is the area over side step and feed: all of it cut at the engagement angle</source>
        <translation>Fogások, átkötések, bemerülések és visszahúzások a pálya saját előtolásaival; a ciklusidő ugyanez. Az ideális a terület osztva az oldallépéssel és az előtolással: minden az átfogási szöggel kimarva</translation>
    </message>
    <message>
        <source>Cycloid</source>
        <translation>Ciklois</translation>
    </message>
    <message>
        <source>Cylindricity</source>
        <translation>Hengeresség</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Csillapítási tényező</translation>
    </message>
    <message>
        <source>Damping, %</source>
        <translation>Csillapítás, %</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 ends too early.</source>
        <translation>%1 58-as adatkészlete túl korán ér véget.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is incomplete or of another kind.</source>
        <translation>%1 58-as adatkészlete hiányos vagy más fajta.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is no frequency response function.</source>
        <translation>%1 58-as adatkészlete nem frekvenciaátvitel.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is no response to a force over frequency.</source>
        <translation>%1 58-as adatkészlete nem erőre adott válasz a frekvencia függvényében.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is not complex.</source>
        <translation>%1 58-as adatkészlete nem komplex.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Mélység</translation>
    </message>
    <message>
        <source>Descent of helix and ramp against the level</source>
        <translation>A csigavonal és a rámpa lejtése a vízszinteshez</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Eltérés</translation>
    </message>
    <message>
        <source>Diameter of the pre-drilled hole; there is no hole until it is set</source>
        <translation>Az előfúrt furat átmérője; amíg nincs megadva, nincs furat</translation>
    </message>
    <message>
        <source>Diameter of the probe&apos;s ball</source>
        <translation>A tapintógömb átmérője</translation>
    </message>
    <message>
        <source>Diameter of the tool centre&apos;s helix; at first 0.9 of the tool&apos;s, and less where that does not fit</source>
        <translation>A szerszámközéppont csigavonalának átmérője; kezdetben a szerszám 0.9-szerese, és kevesebb, ahol az nem fér el</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Irány</translation>
    </message>
    <message>
        <source>Direction of the passes against the X axis, seen from above</source>
        <translation>A sorok iránya az X tengelyhez, felülnézetben</translation>
    </message>
    <message>
        <source>Direction of the vibration, counter-clockwise from machine X</source>
        <translation>A rezgés iránya, a gép X tengelyétől az óramutatóval ellentétesen</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes seen from above; the same as the cusp height on a level face: setting one sets the other</source>
        <translation>A szomszédos sorok távolsága felülnézetben; vízszintes felületen ugyanaz, mint a barázdamagasság: az egyik beállítja a másikat</translation>
    </message>
    <message>
        <source>Down to</source>
        <translation>Mélység</translation>
    </message>
    <message>
        <source>Draws a line at this engagement angle</source>
        <translation>Vonalat húz ennél az átfogási szögnél</translation>
    </message>
    <message>
        <source>Draws a line at this force</source>
        <translation>Vonalat húz ennél az erőnél</translation>
    </message>
    <message>
        <source>Draws a line at this removal rate</source>
        <translation>Vonalat húz ennél az anyagleválasztási sebességnél</translation>
    </message>
    <message>
        <source>Draws the deviations</source>
        <translation>Lerajzolja az eltéréseket</translation>
    </message>
    <message>
        <source>Draws the plots, PNG or SVG</source>
        <translation>Lerajzolja a diagramokat, PNG vagy SVG</translation>
    </message>
    <message>
        <source>Draws these points</source>
        <translation>Lerajzolja a pontokat</translation>
    </message>
    <message>
        <source>Dwells of %1 s count in the total times only, not in those of the samples.</source>
        <translation>%1 s várakozás csak a teljes időkben számít, a mintákéban nem.</translation>
    </message>
    <message>
        <source>Each point needs a normal, and a normal needs a length above 0.</source>
        <translation>Minden ponthoz normális kell, és a normális hossza 0-nál nagyobb legyen.</translation>
    </message>
    <message>
        <source>Each row below the headings holds six numbers.</source>
        <translation>A fejléc alatti minden sorban hat szám van.</translation>
    </message>
    <message>
        <source>Edge%1 of %2</source>
        <translation>%2: Edge%1</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Szerkesztés</translation>
    </message>
    <message>
        <source>Engagement</source>
        <translation>Átfogás</translation>
    </message>
    <message>
        <source>Engagement angle</source>
        <translation>Átfogási szög</translation>
    </message>
    <message>
        <source>Engagement up to %.1f°</source>
        <translation>Átfogás legfeljebb %.1f°</translation>
    </message>
    <message>
        <source>Engagement, °</source>
        <translation>Átfogás, °</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Bemerülés</translation>
    </message>
    <message>
        <source>Entry is &apos;Predrilled hole&apos;, but there is no hole: set EntryPoint and HoleDiameter.</source>
        <translation>[Entry]: „Előfúrt furat”, de nincs furat: adja meg: [EntryPoint] és [HoleDiameter].</translation>
    </message>
    <message>
        <source>Entry is a helix, not a ramp: in this pocket the spiral begins as a circle.</source>
        <translation>[Entry]: csigavonal, nem rámpa: ebben a zsebben a spirál körként kezdődik.</translation>
    </message>
    <message>
        <source>EntryPoint is (%1, %2), outside %3: move it inside.</source>
        <translation>[EntryPoint]: (%1, %2), ezen kívül: %3: helyezze belülre.</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Kiértékelés</translation>
    </message>
    <message>
        <source>Even along each face, or from above over all</source>
        <translation>Egyenletesen minden felületen, vagy felülről az összesen</translation>
    </message>
    <message>
        <source>EvenLoad Adaptive</source>
        <translation>EvenLoad adaptív</translation>
    </message>
    <message>
        <source>EvenLoad Finishing</source>
        <translation>EvenLoad simítás</translation>
    </message>
    <message>
        <source>EvenLoad Lamé Spiral</source>
        <translation>EvenLoad Lamé-spirál</translation>
    </message>
    <message>
        <source>EvenLoad Simulation</source>
        <translation>EvenLoad szimuláció</translation>
    </message>
    <message>
        <source>EvenLoad Trochoid</source>
        <translation>EvenLoad trochoid</translation>
    </message>
    <message>
        <source>EvenLoad failed: %1.</source>
        <translation>Az EvenLoad hibára futott: %1.</translation>
    </message>
    <message>
        <source>EvenLoad&apos;s compiled modules are missing, for %1: %2</source>
        <translation>Hiányoznak az EvenLoad lefordított moduljai, ehhez: %1: %2</translation>
    </message>
    <message>
        <source>EvenLoad&apos;s module %1: %2.</source>
        <translation>Az EvenLoad %1 modulja: %2.</translation>
    </message>
    <message>
        <source>Exponent of the first turn: 1 is an ellipse; fitted unless it is set</source>
        <translation>Az első menet kitevője: 1 ellipszis; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Exponent of the last turn: towards 0 corners grow sharper; fitted unless it is set</source>
        <translation>Az utolsó menet kitevője: 0 felé a sarkok élesednek; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>ExponentCourse changes nothing: the first and the last exponent are the same.</source>
        <translation>[ExponentCourse]: nem változtat semmit: az első és az utolsó kitevő azonos.</translation>
    </message>
    <message>
        <source>ExponentStart and ExponentEnd must lie between 0.05 and 1: above 1 the spiral has corners.</source>
        <translation>[ExponentStart] és [ExponentEnd] 0.05 és 1 közé essen: 1 felett a spirálnak sarkai vannak.</translation>
    </message>
    <message>
        <source>Face%1 of %2</source>
        <translation>%2: Face%1</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Előtolás</translation>
    </message>
    <message>
        <source>Feed control</source>
        <translation>Előtolás-vezérlés</translation>
    </message>
    <message>
        <source>Feed of links at depth over cleared ground; at first the tool controller&apos;s horizontal rapid feed</source>
        <translation>Az átkötések előtolása mélységben, kimart terület felett; kezdetben a szerszámvezérlő vízszintes gyorsjárata</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Előtolások</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fájl…</translation>
    </message>
    <message>
        <source>Final Depth</source>
        <translation>Végső mélység</translation>
    </message>
    <message>
        <source>FinalDepth (%1 mm) keeps the tool&apos;s tip up: lower it if more of the faces is to be reached.</source>
        <translation>[FinalDepth] (%1 mm) fenn tartja a szerszám csúcsát: csökkentse, ha többet kell elérni a felületekből.</translation>
    </message>
    <message>
        <source>FinalDepth lies %1 mm above %2: the rest stays.</source>
        <translation>[FinalDepth]: %1 mm-rel e fölött van: %2: a többi megmarad.</translation>
    </message>
    <message>
        <source>FinalDepth lies %1 mm below %2: the tool cuts into it.</source>
        <translation>[FinalDepth]: %1 mm-rel ez alatt van: %2: a szerszám belevág.</translation>
    </message>
    <message>
        <source>FinalDepth lies %1 mm below the underside of the stock.</source>
        <translation>[FinalDepth]: %1 mm-rel a nyersdarab alja alatt van.</translation>
    </message>
    <message>
        <source>Finds the cut that removes most</source>
        <translation>Megkeresi a legtöbb anyagot leválasztó fogást</translation>
    </message>
    <message>
        <source>First exponent</source>
        <translation>Első kitevő</translation>
    </message>
    <message>
        <source>First semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>A spirál utolsó menetének első féltengelye, a szerszámközépponté; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Fit all again</source>
        <translation>Mindent újra illeszt</translation>
    </message>
    <message>
        <source>Fits modes to a measured frequency response</source>
        <translation>Módusokat illeszt mért frekvenciaátvitelre</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Síklapúság</translation>
    </message>
    <message>
        <source>Fly to the Worst</source>
        <translation>A legrosszabb helyre</translation>
    </message>
    <message>
        <source>Fly to the worst</source>
        <translation>A legrosszabb helyre</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Erő</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Erő, N</translation>
    </message>
    <message>
        <source>Form error</source>
        <translation>Alakhiba</translation>
    </message>
    <message>
        <source>Frequency responses (*.csv *.txt *.unv *.uff *.dat);;All (*)</source>
        <translation>Frekvenciaátvitel (*.csv *.txt *.unv *.uff *.dat);;Minden (*)</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Ettől</translation>
    </message>
    <message>
        <source>From the border of the faces</source>
        <translation>A felületek szélétől</translation>
    </message>
    <message>
        <source>From the window Stability chart</source>
        <translation>A Stabilitási térkép ablakból</translation>
    </message>
    <message>
        <source>Halton-Zaremba has no rows that may miss a fillet</source>
        <translation>A Halton-Zaremba mintának nincsenek sorai, amelyek elkerülhetnének egy lekerekítést</translation>
    </message>
    <message>
        <source>Hammer and sensor</source>
        <translation>Kalapács és érzékelő</translation>
    </message>
    <message>
        <source>Height of what a ball or a rounded corner leaves between two passes of a level face: setting it sets the stepover; 0 for a flat end mill, which leaves steps</source>
        <translation>Amit a gömb vagy a lekerekített sarok vízszintes felület két sora között hagy: beállítja a sortávot; sík végű marónál 0, mert lépcsőket hagy</translation>
    </message>
    <message>
        <source>Helix</source>
        <translation>Csigavonal</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Csigavonal szöge</translation>
    </message>
    <message>
        <source>Helix diameter</source>
        <translation>Csigavonal átmérője</translation>
    </message>
    <message>
        <source>HelixDiameter %1 mm was taken as %2 mm: a wider helix would leave a post in its middle.</source>
        <translation>[HelixDiameter]: %1 mm helyett %2 mm: szélesebb csigavonal közepén csap maradna.</translation>
    </message>
    <message>
        <source>Hole at</source>
        <translation>Furat helye</translation>
    </message>
    <message>
        <source>Hole diameter</source>
        <translation>Furatátmérő</translation>
    </message>
    <message>
        <source>HoleDiameter (%1 mm) is smaller than the tool&apos;s diameter of %2 mm: drill a larger hole or choose another Entry.</source>
        <translation>[HoleDiameter] (%1 mm) kisebb a szerszám %2 mm átmérőjénél: fúrjon nagyobbat, vagy válasszon mást: [Entry].</translation>
    </message>
    <message>
        <source>Horiz. Feed</source>
        <translation>Vízsz. előtolás</translation>
    </message>
    <message>
        <source>How far links rise above the floor; never above the top</source>
        <translation>Mennyire emelkednek az átkötések a fenék fölé; sosem a tető fölé</translation>
    </message>
    <message>
        <source>How far the largest multiplier stays below 1</source>
        <translation>Mennyivel marad 1 alatt a legnagyobb multiplikátor</translation>
    </message>
    <message>
        <source>How much of the tool&apos;s side cuts</source>
        <translation>A szerszám oldalának mekkora része vág</translation>
    </message>
    <message>
        <source>How often the tool rises and comes down again</source>
        <translation>Hányszor emelkedik ki a szerszám, és merül be újra</translation>
    </message>
    <message>
        <source>How the first semi-axis comes from the first turn to the last: 2 to 20 shares of its change, from 0 to 1, at even steps, as 0; 0.1; 0.4; 1; evenly where it is empty</source>
        <translation>Hogyan jut az első féltengely az első menettől az utolsóig: változásának 2–20 hányada, 0-tól 1-ig, egyenletes lépésekben, például 0; 0.1; 0.4; 1; üresen egyenletesen</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>Események</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Vizsgálat</translation>
    </message>
    <message>
        <source>Inspects the faces that are selected</source>
        <translation>A kijelölt felületeket vizsgálja</translation>
    </message>
    <message>
        <source>Its force coefficients</source>
        <translation>Az anyag forgácsolóerő-együtthatói</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Mozgás fajtája</translation>
    </message>
    <message>
        <source>Largest cutting force in the plane</source>
        <translation>A legnagyobb forgácsolóerő a síkban</translation>
    </message>
    <message>
        <source>Largest distance of the output from the exact path; never into a wall</source>
        <translation>A kimenet legnagyobb eltérése a pontos pályától; sosem a falba</translation>
    </message>
    <message>
        <source>Largest engagement angle, mean over 0.1 mm of the path</source>
        <translation>A legnagyobb átfogási szög, a pálya 0.1 mm-ére átlagolva</translation>
    </message>
    <message>
        <source>Largest error of the wall&apos;s place</source>
        <translation>A fal helyzetének legnagyobb hibája</translation>
    </message>
    <message>
        <source>Last exponent</source>
        <translation>Utolsó kitevő</translation>
    </message>
    <message>
        <source>Least load</source>
        <translation>Legkisebb terhelés</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Meghagyás</translation>
    </message>
    <message>
        <source>Left uncut: %1 mm² %2, for the turned-off WallPass, or where the tool has too little room to turn.</source>
        <translation>Kimaratlan: %1 mm² %2, mert ki van kapcsolva: [WallPass], vagy ahol a szerszámnak túl kevés helye van fordulni.</translation>
    </message>
    <message>
        <source>Left uncut: %1 mm² %2, where the tool has too little room to turn within the engagement limit.</source>
        <translation>Kimaratlan: %1 mm² %2, ahol a szerszámnak túl kevés helye van az átfogási határon belül fordulni.</translation>
    </message>
    <message>
        <source>Left uncut: %1 mm² that the spiral does not reach, for Rest is &apos;Leave&apos;.</source>
        <translation>Kimaratlan: %1 mm², amelyet a spirál nem ér el, mert [Rest]: „Meghagyás”.</translation>
    </message>
    <message>
        <source>Length of cuts and of ways along the surface</source>
        <translation>A fogások és a felület menti utak hossza</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Határok</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Átkötési előtolás</translation>
    </message>
    <message>
        <source>Link lift</source>
        <translation>Kiemelés</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>Élő előnézet</translation>
    </message>
    <message>
        <source>Load a tap test, open a file with modes, or add a mode: the chart follows from what vibrates at the tool&apos;s tip.</source>
        <translation>Töltsön be kopogtatásos mérést, nyisson meg módusokat tartalmazó fájlt, vagy adjon hozzá módust: a diagram abból következik, ami a szerszám csúcsán rezeg.</translation>
    </message>
    <message>
        <source>Load of %s</source>
        <translation>%s terhelése</translation>
    </message>
    <message>
        <source>Location error</source>
        <translation>Helyzethiba</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Gép</translation>
    </message>
    <message>
        <source>Made from the models themselves: the path keeps off all of the job&apos;s.</source>
        <translation>Magukból a modellekből készült: a pálya a feladat összes modelljétől távol marad.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Távolság</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Anyag</translation>
    </message>
    <message>
        <source>Material stands%1 above StartDepth (%2 mm), near (%3, %4): raise StartDepth, or clear it before.</source>
        <translation>Anyag áll%1 e fölött: [StartDepth] (%2 mm), itt: (%3, %4): növelje: [StartDepth], vagy marja ki előbb.</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Mátrix</translation>
    </message>
    <message>
        <source>Maximum feed</source>
        <translation>Legnagyobb előtolás</translation>
    </message>
    <message>
        <source>MaximumFeed is %1 mm/min: it must not be below the tool controller&apos;s horizontal feed of %2 mm/min.</source>
        <translation>[MaximumFeed]: %1 mm/min: ne legyen a szerszámvezérlő vízszintes előtolása, %2 mm/min alatt.</translation>
    </message>
    <message>
        <source>Minimum radius</source>
        <translation>Legkisebb sugár</translation>
    </message>
    <message>
        <source>Mode %1 of &apos;%2&apos;</source>
        <translation>„%2” %1. módusa</translation>
    </message>
    <message>
        <source>Mode %d: %s</source>
        <translation>%d. módus: %s</translation>
    </message>
    <message>
        <source>Mode %d: &apos;%s&apos; is no number.</source>
        <translation>%d. módus: „%s” nem szám.</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Módusok</translation>
    </message>
    <message>
        <source>Modes are a JSON file, an object or a list of modes, not %1.</source>
        <translation>A módusok JSON-fájl, objektum vagy módusok listája, nem pedig %1.</translation>
    </message>
    <message>
        <source>Modes of vibration</source>
        <translation>Rezgésmódusok</translation>
    </message>
    <message>
        <source>More than two edges meet at (%1, %2): leave only the outline&apos;s own, without doubles.</source>
        <translation>Kettőnél több él találkozik itt: (%1, %2): csak a körvonalét hagyja meg, kettőzés nélkül.</translation>
    </message>
    <message>
        <source>Most blocks per metre</source>
        <translation>Legtöbb mondat méterenként</translation>
    </message>
    <message>
        <source>Moves the tool along the path</source>
        <translation>A szerszámot a pálya mentén mozgatja</translation>
    </message>
    <message>
        <source>Narrow passages</source>
        <translation>Szűk helyek</translation>
    </message>
    <message>
        <source>Natural frequency</source>
        <translation>Sajátfrekvencia</translation>
    </message>
    <message>
        <source>No cut in the chart keeps the limits.</source>
        <translation>A diagram egyik fogása sem tartja be a határokat.</translation>
    </message>
    <message>
        <source>No cut leads on from a ramp: the tool comes down by a helix instead.</source>
        <translation>Rámpáról nem folytatható fogás: a szerszám helyette csigavonalon merül be.</translation>
    </message>
    <message>
        <source>No face is picked: pick the faces that are measured.</source>
        <translation>Nincs kijelölt felület: jelölje ki a mért felületeket.</translation>
    </message>
    <message>
        <source>No feed down to a tenth of the nominal keeps the force at that of a straight cut at the engagement angle %1: raise EngagementAngle or HorizFeed, or choose another FeedControl.</source>
        <translation>A névleges tizedéig semmilyen előtolás nem tartja az erőt az egyenes fogásén az átfogási szöggel %1: növelje: [EngagementAngle] vagy [HorizFeed], vagy válasszon mást: [FeedControl].</translation>
    </message>
    <message>
        <source>No file is open.</source>
        <translation>Nincs megnyitott fájl.</translation>
    </message>
    <message>
        <source>No helix fits: the tool comes down along a ramp instead.</source>
        <translation>Nem fér el csigavonal: a szerszám helyette rámpán merül be.</translation>
    </message>
    <message>
        <source>No spiral was made: with narrow passages it is cleared at constant engagement; set NarrowPassages to &apos;Skip and report&apos; for a spiral.</source>
        <translation>Nem készült spirál: szűk helyekkel állandó átfogással mar; spirálhoz állítsa be: [NarrowPassages]: „Kihagyás és jelentés”.</translation>
    </message>
    <message>
        <source>No trochoid was repeated %1, %2: this region was cleared pass by pass%3.</source>
        <translation>Nem ismétlődött trochoid %1, %2: ez a terület fogásonként lett kimarva%3.</translation>
    </message>
    <message>
        <source>No vertical line meets the faces within the margin: take a smaller one, or space the points by arc length.</source>
        <translation>Egyetlen függőleges sem éri a felületeket a peremen belül: vegyen kisebbet, vagy ossza el a pontokat ívhossz szerint.</translation>
    </message>
    <message>
        <source>No zone near by is narrower (contacts: %1; balance of their forces: %2).</source>
        <translation>Nincs keskenyebb zóna a közelben (érintkezések: %1; erőik egyensúlya: %2).</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nincs</translation>
    </message>
    <message>
        <source>None of the picked faces can be seen from above: pick others, or turn the model.</source>
        <translation>A kijelölt felületek egyike sem látszik felülről: válasszon másikat, vagy fordítsa el a modellt.</translation>
    </message>
    <message>
        <source>None: programmed feeds</source>
        <translation>Nincs: programozott előtolás</translation>
    </message>
    <message>
        <source>Not active: there is no path</source>
        <translation>Nem aktív: nincs pálya</translation>
    </message>
    <message>
        <source>Not checked against the model: Check is off.</source>
        <translation>Nincs ellenőrizve a modellel: kikapcsolva: [Check].</translation>
    </message>
    <message>
        <source>Not computed yet: Apply computes the path</source>
        <translation>Még nincs kiszámítva: az Alkalmaz kiszámítja a pályát</translation>
    </message>
    <message>
        <source>Nothing was left to cut: earlier cuts have cleared all that this tool can reach.</source>
        <translation>Nem maradt mit marni: a korábbi fogások mindent kimartak, amit ez a szerszám elér.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Darab</translation>
    </message>
    <message>
        <source>Of a file that holds centres of the probe&apos;s ball</source>
        <translation>A tapintógömb középpontjait tartalmazó fájlé</translation>
    </message>
    <message>
        <source>Of several regions: each down to its last level, or all level by level</source>
        <translation>Több területnél: mindegyiket az utolsó szintjéig, vagy az összeset szintenként</translation>
    </message>
    <message>
        <source>Of the first semi-axis against the X axis; fitted unless it is set</source>
        <translation>Az első féltengelyé az X tengelyhez; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Of the probing program</source>
        <translation>A mérőprogramé</translation>
    </message>
    <message>
        <source>Of the tool&apos;s flank on the wall it has cut; some 100 kN/m, more with a worn edge</source>
        <translation>A hátlapé a kimart falon; körülbelül 100 kN/m, kopott élnél több</translation>
    </message>
    <message>
        <source>Of these faces alone</source>
        <translation>Csak e felületeké</translation>
    </message>
    <message>
        <source>On the machine</source>
        <translation>A gépen</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Egy irány</translation>
    </message>
    <message>
        <source>Only a profile has free motions or a datum: take these out.</source>
        <translation>Csak profilnak van szabad mozgása vagy bázisa: hagyja el ezeket.</translation>
    </message>
    <message>
        <source>Open Machine Profile</source>
        <translation>Gépprofil megnyitása</translation>
    </message>
    <message>
        <source>Open Measured Points</source>
        <translation>Mért pontok megnyitása</translation>
    </message>
    <message>
        <source>Open a tap test</source>
        <translation>Kopogtatásos mérés megnyitása</translation>
    </message>
    <message>
        <source>Open modes</source>
        <translation>Módusok megnyitása</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Megnyitás...</translation>
    </message>
    <message>
        <source>OpenCASCADE could not triangulate the shape: %1.</source>
        <translation>Az OpenCASCADE nem tudta háromszögekre bontani az alakot: %1.</translation>
    </message>
    <message>
        <source>OpenCASCADE could not work on the shape: %1.</source>
        <translation>Az OpenCASCADE nem tudta feldolgozni az alakot: %1.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Megnyitás…</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Művelet</translation>
    </message>
    <message>
        <source>Order by</source>
        <translation>Sorrend</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Sorok</translation>
    </message>
    <message>
        <source>Passes %d</source>
        <translation>Sorok %d</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Pálya</translation>
    </message>
    <message>
        <source>Path %s</source>
        <translation>Pálya %s</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Minta</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Kép…</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Menetköz</translation>
    </message>
    <message>
        <source>Pitch is smaller than set in some turns, down to %1 mm: the engagement angle allows no more there.</source>
        <translation>[Pitch]: egyes menetekben kisebb a megadottnál, akár %1 mm: ott az átfogási szög nem enged többet.</translation>
    </message>
    <message>
        <source>Pitch must be positive.</source>
        <translation>[Pitch] pozitív legyen.</translation>
    </message>
    <message>
        <source>Point %1 has a coordinate that is not a number: leave it out.</source>
        <translation>A(z) %1. pont egyik koordinátája nem szám: hagyja el.</translation>
    </message>
    <message>
        <source>Point %1 lies %2 mm from the faces: pick the faces that were measured, align the points with the model, or leave it out.</source>
        <translation>A(z) %1. pont %2 mm-re van a felületektől: jelölje ki a mért felületeket, igazítsa a pontokat a modellhez, vagy hagyja el.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontok</translation>
    </message>
    <message>
        <source>Points are rows of %1 numbers.</source>
        <translation>A pontok %1 számból álló sorok.</translation>
    </message>
    <message>
        <source>Points nearer to other faces, left out: %1.</source>
        <translation>Más felületekhez közelebbi, elhagyott pontok: %1.</translation>
    </message>
    <message>
        <source>Points…</source>
        <translation>Pontok…</translation>
    </message>
    <message>
        <source>Post-processor</source>
        <translation>Posztprocesszor</translation>
    </message>
    <message>
        <source>Predrilled hole</source>
        <translation>Előfúrt furat</translation>
    </message>
    <message>
        <source>Preview: Apply checks and stores the path</source>
        <translation>Előnézet: az Alkalmaz ellenőrzi és tárolja a pályát</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Tapintó</translation>
    </message>
    <message>
        <source>Probing Program…</source>
        <translation>Mérőprogram…</translation>
    </message>
    <message>
        <source>Process damping</source>
        <translation>Folyamatcsillapítás</translation>
    </message>
    <message>
        <source>Python %1 and OpenCASCADE %2</source>
        <translation>Python %1 és OpenCASCADE %2</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rámpa</translation>
    </message>
    <message>
        <source>Reads measured points, CSV or DMIS</source>
        <translation>Mért pontokat olvas be, CSV vagy DMIS</translation>
    </message>
    <message>
        <source>Reads modes from a file</source>
        <translation>Módusokat olvas fájlból</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Terület</translation>
    </message>
    <message>
        <source>Remarks (%d)</source>
        <translation>Megjegyzések (%d)</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Anyagleválasztás</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Törlés</translation>
    </message>
    <message>
        <source>Removes the selected modes</source>
        <translation>A kijelölt módusokat eltávolítja</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Jelentés…</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Maradék</translation>
    </message>
    <message>
        <source>Rest machining</source>
        <translation>Maradékmegmunkálás</translation>
    </message>
    <message>
        <source>Retracts %d</source>
        <translation>Visszahúzások %d</translation>
    </message>
    <message>
        <source>Roll radius</source>
        <translation>Begördülési sugár</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Elforgatás</translation>
    </message>
    <message>
        <source>Rotation must be finite.</source>
        <translation>[Rotation] véges legyen.</translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation>Köralak</translation>
    </message>
    <message>
        <source>Safe Height</source>
        <translation>Biztonsági magasság</translation>
    </message>
    <message>
        <source>SafeHeight (%1 mm) lies below StartDepth (%2 mm): raise it.</source>
        <translation>[SafeHeight] (%1 mm) ez alatt van: [StartDepth] (%2 mm): növelje.</translation>
    </message>
    <message>
        <source>SafeHeight (%1 mm) lies below the top of the models (%2 mm): raise it.</source>
        <translation>[SafeHeight] (%1 mm) a modellek teteje (%2 mm) alatt van: növelje.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Kép mentése</translation>
    </message>
    <message>
        <source>Save Points</source>
        <translation>Pontok mentése</translation>
    </message>
    <message>
        <source>Save Probing Program</source>
        <translation>Mérőprogram mentése</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Jelentés mentése</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Táblázat mentése</translation>
    </message>
    <message>
        <source>Save modes</source>
        <translation>Módusok mentése</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Mentés...</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Keresés</translation>
    </message>
    <message>
        <source>Second semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>A spirál utolsó menetének második féltengelye, a szerszámközépponté; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Oldalak</translation>
    </message>
    <message>
        <source>Segments must lie between 3 and 12.</source>
        <translation>[Segments]: 3 és 12 közé essen.</translation>
    </message>
    <message>
        <source>Select level faces, closed edges or sketches.</source>
        <translation>Vízszintes felületeket, zárt éleket vagy vázlatokat válasszon ki.</translation>
    </message>
    <message>
        <source>Semi-axes of two lengths need Segments 4: set both to the same length, or leave one unset.</source>
        <translation>Két különböző féltengelyhez 4 kell itt: [Segments]: állítsa mindkettőt azonosra, vagy az egyiket hagyja megadatlanul.</translation>
    </message>
    <message>
        <source>Semi-axis A</source>
        <translation>A féltengely</translation>
    </message>
    <message>
        <source>Semi-axis B</source>
        <translation>B féltengely</translation>
    </message>
    <message>
        <source>SemiAxisA and SemiAxisB must be positive lengths.</source>
        <translation>[SemiAxisA] és [SemiAxisB] pozitív hossz legyen.</translation>
    </message>
    <message>
        <source>Sets spindle speed, feeds, step down and cut mode</source>
        <translation>Beállítja a fordulatszámot, az előtolásokat, a fogásmélységet és a marási irányt</translation>
    </message>
    <message>
        <source>Shows all of the time</source>
        <translation>A teljes időt mutatja</translation>
    </message>
    <message>
        <source>Shows the path in the 3D view while values change</source>
        <translation>A pályát a 3D nézetben mutatja, miközben az értékek változnak</translation>
    </message>
    <message>
        <source>Shows the place with the largest value</source>
        <translation>A legnagyobb érték helyét mutatja</translation>
    </message>
    <message>
        <source>Side step</source>
        <translation>Oldallépés</translation>
    </message>
    <message>
        <source>SideStep is %1 mm: it must lie between 0 and the tool&apos;s diameter of %2 mm.</source>
        <translation>[SideStep]: %1 mm: 0 és a szerszám átmérője, %2 mm közé essen.</translation>
    </message>
    <message>
        <source>Sides of the curve: 3 for a triangle, 4 for a square or a rectangle; fitted unless it is set</source>
        <translation>A görbe oldalai: 3 háromszöghöz, 4 négyzethez vagy téglalaphoz; illesztett, amíg nincs megadva</translation>
    </message>
    <message>
        <source>Simulates the job and writes a report to print, HTML</source>
        <translation>Szimulálja a feladatot, és nyomtatható jelentést ír, HTML</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Szimuláció</translation>
    </message>
    <message>
        <source>Skip and report</source>
        <translation>Kihagyás és jelentés</translation>
    </message>
    <message>
        <source>Skipped%1: the passage %2, %3 mm wide at its narrowest%4.</source>
        <translation>Kihagyva%1: a szűk hely %2, legkeskenyebb részén %3 mm széles%4.</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Horony</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>Horonyszélesség</translation>
    </message>
    <message>
        <source>SlotWidth (%1 mm) is less than the tool&apos;s diameter of %2 mm: take a smaller tool or widen the slot.</source>
        <translation>[SlotWidth] (%1 mm) kisebb a szerszám %2 mm átmérőjénél: vegyen kisebb szerszámot, vagy szélesítse a hornyot.</translation>
    </message>
    <message>
        <source>SlotWidth was not used for %1: a face has its own width.</source>
        <translation>[SlotWidth]: nem lett használva ehhez: %1: a felületnek saját szélessége van.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Térköz</translation>
    </message>
    <message>
        <source>Spacing is &apos;%1&apos;, but the tool &apos;%2&apos; has a flat end, which leaves steps: take a ball end mill, or another Spacing.</source>
        <translation>[Spacing]: „%1”, de a(z) „%2” szerszám vége sík, ezért lépcsőket hagy: vegyen gömbvégű marót, vagy válasszon mást: [Spacing].</translation>
    </message>
    <message>
        <source>Sphericity</source>
        <translation>Gömbalak</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Orsó</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Fordulatszám</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirál</translation>
    </message>
    <message>
        <source>Stability chart</source>
        <translation>Stabilitási térkép</translation>
    </message>
    <message>
        <source>Start Depth</source>
        <translation>Kezdeti mélység</translation>
    </message>
    <message>
        <source>StartDepth (%1 mm) does not lie above FinalDepth (%2 mm): raise StartDepth or lower FinalDepth.</source>
        <translation>[StartDepth] (%1 mm) nincs e fölött: [FinalDepth] (%2 mm): növelje: [StartDepth], vagy csökkentse: [FinalDepth].</translation>
    </message>
    <message>
        <source>StartDepth (%1 mm) does not lie above the underside of the stock (%2 mm): there is nothing to cut.</source>
        <translation>[StartDepth] (%1 mm) nincs a nyersdarab alja (%2 mm) felett: nincs mit marni.</translation>
    </message>
    <message>
        <source>Stays on the faces</source>
        <translation>A felületeken marad</translation>
    </message>
    <message>
        <source>Step Down</source>
        <translation>Fogásmélység</translation>
    </message>
    <message>
        <source>Step down</source>
        <translation>Fogásmélység</translation>
    </message>
    <message>
        <source>StepDown is %1 mm: from StartDepth to FinalDepth that makes more than %2 levels, raise it.</source>
        <translation>[StepDown]: %1 mm: [StartDepth] és [FinalDepth] között ez több mint %2 szint, növelje.</translation>
    </message>
    <message>
        <source>StepDown is %1 mm: it must be positive.</source>
        <translation>[StepDown]: %1 mm: pozitív legyen.</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Sortáv</translation>
    </message>
    <message>
        <source>Stepover is %1 mm, more than the tool&apos;s diameter of %2 mm: lower it.</source>
        <translation>[Stepover]: %1 mm, több a szerszám %2 mm átmérőjénél: csökkentse.</translation>
    </message>
    <message>
        <source>Stiffness of the mode</source>
        <translation>A módus merevsége</translation>
    </message>
    <message>
        <source>Stock at the floor</source>
        <translation>Ráhagyás a fenéken</translation>
    </message>
    <message>
        <source>Stock to leave</source>
        <translation>Ráhagyás</translation>
    </message>
    <message>
        <source>StockToLeaveAxial is %1 mm: between StartDepth (%2 mm) and FinalDepth (%3 mm) that leaves nothing to cut, lower it.</source>
        <translation>[StockToLeaveAxial]: %1 mm: így [StartDepth] (%2 mm) és [FinalDepth] (%3 mm) között nem marad mit marni, csökkentse.</translation>
    </message>
    <message>
        <source>Stops the simulation</source>
        <translation>Leállítja a szimulációt</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Egyenesség</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégia</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Táblázat…</translation>
    </message>
    <message>
        <source>Take Selected Faces</source>
        <translation>Kijelölt felületek átvétele</translation>
    </message>
    <message>
        <source>Tap test</source>
        <translation>Kopogtatásos mérés</translation>
    </message>
    <message>
        <source>Tap test %1 of &apos;%2&apos;</source>
        <translation>„%2” %1. mérése</translation>
    </message>
    <message>
        <source>Tap test...</source>
        <translation>Kopogtatás...</translation>
    </message>
    <message>
        <source>Target and limit of the tool&apos;s engagement angle, between 0 and 180 degrees</source>
        <translation>Az átfogási szög célja és határa, 0 és 180 fok között</translation>
    </message>
    <message>
        <source>That it is the narrowest zone is not proved: take it for an upper bound.</source>
        <translation>Nem bizonyított, hogy ez a legkeskenyebb zóna: vegye felső korlátnak.</translation>
    </message>
    <message>
        <source>The %1 feed of the tool controller &apos;%2&apos; is 0: set its %3.</source>
        <translation>A(z) „%2” szerszámvezérlő előtolása (%1) 0: állítsa be: %3.</translation>
    </message>
    <message>
        <source>The %1 must be above 0, not %2.</source>
        <translation>0 felett legyen, nem pedig %2: %1.</translation>
    </message>
    <message>
        <source>The chart is that of this cut mode</source>
        <translation>A diagram erre a marási irányra érvényes</translation>
    </message>
    <message>
        <source>The chart&apos;s largest depth</source>
        <translation>A diagram legnagyobb mélysége</translation>
    </message>
    <message>
        <source>The chart&apos;s largest spindle speed</source>
        <translation>A diagram legnagyobb fordulatszáma</translation>
    </message>
    <message>
        <source>The chart&apos;s least spindle speed</source>
        <translation>A diagram legkisebb fordulatszáma</translation>
    </message>
    <message>
        <source>The chart&apos;s speeds must rise.</source>
        <translation>A diagram fordulatszámainak növekedniük kell.</translation>
    </message>
    <message>
        <source>The coherence around %1 Hz falls to %2: measure it again.</source>
        <translation>A koherencia %1 Hz körül %2 értékre esik: mérje meg újra.</translation>
    </message>
    <message>
        <source>The cut is stable at %1 rev/min and %2 mm%3.</source>
        <translation>A fogás stabil %1 ford/perc és %2 mm mellett%3.</translation>
    </message>
    <message>
        <source>The cut is unstable: %1 mm deep at %2 rev/min it chatters near %3 Hz, worst where the feed is at %4° to X; %5.</source>
        <translation>A fogás instabil: %1 mm mélyen %2 ford/perc mellett %3 Hz közelében rezeg be, leginkább ott, ahol az előtolás iránya %4° az X-hez; %5.</translation>
    </message>
    <message>
        <source>The datum is one plane face, not %1.</source>
        <translation>A bázis egyetlen sík felület, nem pedig %1.</translation>
    </message>
    <message>
        <source>The deflection and the angle must be positive.</source>
        <translation>Az eltérés és a szög pozitív legyen.</translation>
    </message>
    <message>
        <source>The depth of %1 mm is beyond the tool&apos;s flutes, %2 mm.</source>
        <translation>A(z) %1 mm mélység túlnyúlik a szerszám élein, %2 mm.</translation>
    </message>
    <message>
        <source>The depth of %1 mm is more than the cutting length of %2 mm of the tool &apos;%3&apos;: take a longer tool or raise FinalDepth.</source>
        <translation>A(z) %1 mm mélység több, mint a(z) „%3” szerszám %2 mm vágóhossza: vegyen hosszabbat, vagy növelje: [FinalDepth].</translation>
    </message>
    <message>
        <source>The diameter of the tool &apos;%1&apos; is %2 mm: set it.</source>
        <translation>A(z) „%1” szerszám átmérője %2 mm: adja meg.</translation>
    </message>
    <message>
        <source>The engagement angle as the side step of a straight cut, r (1 - cos angle): setting one sets the other</source>
        <translation>Az átfogási szög egyenes fogás oldallépéseként, r (1 - cos szög): az egyik beállítja a másikat</translation>
    </message>
    <message>
        <source>The engagement angle of &apos;%1&apos; is %2°: it must lie above 0, where nothing is cut, and at most at 180°.</source>
        <translation>„%1” átfogási szöge %2°: 0 felett legyen, ahol nincs fogás, és legfeljebb 180°.</translation>
    </message>
    <message>
        <source>The expression of %1, &apos;%2&apos;, cannot be evaluated: mend it.</source>
        <translation>%1 kifejezése, „%2”, nem értékelhető ki: javítsa ki.</translation>
    </message>
    <message>
        <source>The face has no boundary: pick a finite one.</source>
        <translation>A felületnek nincs határa: jelöljön ki végeset.</translation>
    </message>
    <message>
        <source>The face is not flat: pick a flat face that is parallel to XY.</source>
        <translation>A felület nem sík: jelöljön ki XY-nal párhuzamos sík felületet.</translation>
    </message>
    <message>
        <source>The face is tilted by %1 degrees: pick one that is parallel to XY.</source>
        <translation>A felület %1 fokkal ferde: jelöljön ki XY-nal párhuzamosat.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; must hold one %2, a JSON object.</source>
        <translation>A(z) „%1” fájl egy JSON-objektumot tartalmazzon: %2.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of the %2 cannot be read: %3.</source>
        <translation>A(z) „%1” fájl (%2) nem olvasható: %3.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of the %2 is no JSON: %3.</source>
        <translation>A(z) „%1” fájl (%2) nem JSON: %3.</translation>
    </message>
    <message>
        <source>The file cannot be written (%s): name another one.</source>
        <translation>A fájl nem írható (%s): adjon meg másikat.</translation>
    </message>
    <message>
        <source>The file has no measured points, FA(name)=FEAT/POINT,CART.</source>
        <translation>A fájlban nincsenek mért pontok, FA(name)=FEAT/POINT,CART.</translation>
    </message>
    <message>
        <source>The file is empty: it needs the headings x [mm], y [mm], z [mm], i, j, k.</source>
        <translation>A fájl üres: x [mm], y [mm], z [mm], i, j, k fejléc kell bele.</translation>
    </message>
    <message>
        <source>The file mixes mm and inch: write it anew in one unit.</source>
        <translation>A fájl keveri a mm és az inch egységet: írja újra egyetlen egységgel.</translation>
    </message>
    <message>
        <source>The file states no unit before its points: add UNITS/MM or UNITS/INCH.</source>
        <translation>A fájl nem ad meg mértékegységet a pontok előtt: írja bele: UNITS/MM vagy UNITS/INCH.</translation>
    </message>
    <message>
        <source>The frequencies of %1 do not rise from line to line.</source>
        <translation>%1 frekvenciái nem növekednek soronként.</translation>
    </message>
    <message>
        <source>The frequencies of the response must be numbers from 0 on.</source>
        <translation>Az átvitel frekvenciái legalább 0 értékű számok legyenek.</translation>
    </message>
    <message>
        <source>The frequencies of the response must rise from line to line.</source>
        <translation>Az átvitel frekvenciái soronként növekedjenek.</translation>
    </message>
    <message>
        <source>The frequency of a mode must be a number of Hz above 0.</source>
        <translation>A módus frekvenciája 0-nál nagyobb szám legyen, Hz.</translation>
    </message>
    <message>
        <source>The frequency response has too few lines for so many modes.</source>
        <translation>Az átvitelnek ennyi módushoz túl kevés sora van.</translation>
    </message>
    <message>
        <source>The headings are x [mm], y [mm], z [mm], i, j, k, with mm or inch.</source>
        <translation>A fejléc x [mm], y [mm], z [mm], i, j, k, mm vagy inch egységgel.</translation>
    </message>
    <message>
        <source>The headings of x, y and z state different units: state one.</source>
        <translation>Az x, y és z fejléce eltérő mértékegységet mond: adjon meg egyet.</translation>
    </message>
    <message>
        <source>The imaginary part is positive at the peak at %1 Hz: the sign, or the unit, is wrong.</source>
        <translation>A képzetes rész pozitív a(z) %1 Hz-es csúcsnál: az előjel vagy a mértékegység hibás.</translation>
    </message>
    <message>
        <source>The job &apos;%1&apos; has no model: add one to it.</source>
        <translation>A(z) „%1” feladatnak nincs modellje: adjon hozzá egyet.</translation>
    </message>
    <message>
        <source>The job &apos;%1&apos; has no stock: give it one.</source>
        <translation>A(z) „%1” feladatnak nincs nyersdarabja: adjon hozzá egyet.</translation>
    </message>
    <message>
        <source>The job has no operation with a tool: create one first.</source>
        <translation>A feladatnak nincs szerszámos művelete: előbb hozzon létre egyet.</translation>
    </message>
    <message>
        <source>The largest step of a turn; fitted to the engagement angle unless it is set, and smaller where that demands it</source>
        <translation>Egy menet legnagyobb lépése; az átfogási szöghöz illesztett, amíg nincs megadva, és kisebb, ahol az megkívánja</translation>
    </message>
    <message>
        <source>The machine &apos;%1&apos; has no %2: give it one number, or one each for x, y and z.</source>
        <translation>„%1” gép: nincs %2: adjon meg egy számot, vagy egyet-egyet x, y és z számára.</translation>
    </message>
    <message>
        <source>The machine &apos;%1&apos; has the unknown key &apos;%2&apos;: its keys are %3.</source>
        <translation>„%1” gép: ismeretlen kulcs: „%2”; a kulcsok: %3.</translation>
    </message>
    <message>
        <source>The margin must lie from 0 to below 1.</source>
        <translation>A tartalék 0 és 1 közé essen, 1 alatt.</translation>
    </message>
    <message>
        <source>The margin of %1 mm leaves nothing of %2 of %3: take a smaller one.</source>
        <translation>A(z) %1 mm perem semmit sem hagy: %3, %2: vegyen kisebbet.</translation>
    </message>
    <message>
        <source>The material &apos;%1&apos; has no %2: give it one in N/mm2.</source>
        <translation>„%1” anyag: nincs %2: adja meg, N/mm2.</translation>
    </message>
    <message>
        <source>The material &apos;%1&apos; has the unknown key &apos;%2&apos;: its keys are %3.</source>
        <translation>„%1” anyag: ismeretlen kulcs: „%2”; a kulcsok: %3.</translation>
    </message>
    <message>
        <source>The modes of &apos;%1&apos;</source>
        <translation>„%1” módusai</translation>
    </message>
    <message>
        <source>The name of a file of points ends in .csv or %1, not as %2.</source>
        <translation>A pontfájl neve .csv vagy %1 végű, nem pedig %2.</translation>
    </message>
    <message>
        <source>The number of points is 1 to %1, not %2.</source>
        <translation>A pontok száma 1 és %1 közötti, nem pedig %2.</translation>
    </message>
    <message>
        <source>The open edges %1 leave no clear room outside: they were taken for walls.</source>
        <translation>A nyitott élek %1 kívül nem hagynak szabad helyet: falnak számítanak.</translation>
    </message>
    <message>
        <source>The operation has no base geometry: pick a face or a sketch for it.</source>
        <translation>A műveletnek nincs alapgeometriája: jelöljön ki hozzá felületet vagy vázlatot.</translation>
    </message>
    <message>
        <source>The operation has no base geometry: pick the faces to be finished.</source>
        <translation>A műveletnek nincs alapgeometriája: jelölje ki a simítandó felületeket.</translation>
    </message>
    <message>
        <source>The operation has no tool: choose a tool controller for it.</source>
        <translation>A műveletnek nincs szerszáma: válasszon hozzá szerszámvezérlőt.</translation>
    </message>
    <message>
        <source>The outline</source>
        <translation>A körvonal</translation>
    </message>
    <message>
        <source>The outline and an island cross or touch near (%1, %2): move them apart in the sketch, or join them into one curve.</source>
        <translation>A körvonal és egy sziget metszi vagy érinti egymást itt: (%1, %2): távolítsa el őket egymástól a vázlatban, vagy egyesítse egy görbévé.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself near (%1, %2): remove the crossing in the sketch.</source>
        <translation>A körvonal metszi vagy érinti önmagát itt: (%1, %2): szüntesse meg a metszést a vázlatban.</translation>
    </message>
    <message>
        <source>The outline is open at (%1, %2), the nearest other end is %3 mm away: close it.</source>
        <translation>A körvonal nyitott itt: (%1, %2), a legközelebbi másik vég %3 mm-re van: zárja be.</translation>
    </message>
    <message>
        <source>The path could not be computed.</source>
        <translation>A pálya nem volt kiszámítható.</translation>
    </message>
    <message>
        <source>The path cuts %1 mm into &apos;%2&apos; %3: change the depths, or what is picked.</source>
        <translation>A pálya %1 mm-re belevág: „%2” %3: módosítsa a mélységeket vagy a kijelölést.</translation>
    </message>
    <message>
        <source>The path goes %1 mm below StartDepth, and the tool &apos;%2&apos; cuts over %3 mm of its length: see that its shank stays off the part.</source>
        <translation>A pálya %1 mm-rel ez alá megy: [StartDepth], a(z) „%2” szerszám pedig %3 mm hosszon vág: ügyeljen rá, hogy a szára ne érje a darabot.</translation>
    </message>
    <message>
        <source>The path has a rapid through %1 mm of material %2: raise StartDepth and SafeHeight above what stands there, or clear it before.</source>
        <translation>A pályán gyorsjárat halad át %1 mm anyagon %2: növelje az ott álló anyag fölé: [StartDepth] és [SafeHeight], vagy marja ki előbb.</translation>
    </message>
    <message>
        <source>The path has more than %1 levels and the model leans: no part is taken.</source>
        <translation>A pályának több mint %1 szintje van, és a modell ferde: nincs figyelembe vett darab.</translation>
    </message>
    <message>
        <source>The path of &apos;%1&apos; cannot be checked: %2</source>
        <translation>„%1” pályája nem ellenőrizhető: %2</translation>
    </message>
    <message>
        <source>The path of &apos;%1&apos;, which comes before &apos;%2&apos;, is not up to date: recompute the document once more.</source>
        <translation>„%1” pályája, amely „%2” előtt van, nem aktuális: számítsa újra a dokumentumot még egyszer.</translation>
    </message>
    <message>
        <source>The path plunges into %1 mm of material %2: raise StartDepth above what stands there, clear it before, or choose another Entry.</source>
        <translation>A pálya függőlegesen merül %1 mm anyagba %2: növelje az ott álló anyag fölé: [StartDepth], marja ki előbb, vagy válasszon mást: [Entry].</translation>
    </message>
    <message>
        <source>The peak at %1 Hz is %2 lines wide: measure with a finer resolution.</source>
        <translation>A(z) %1 Hz-es csúcs %2 sor széles: mérjen finomabb felbontással.</translation>
    </message>
    <message>
        <source>The pocket %1 was skipped. The tool of %2 mm does not fit into the pocket: %3</source>
        <translation>A zseb %1 kimaradt. A(z) %2 mm-es szerszám nem fér a zsebbe: %3</translation>
    </message>
    <message>
        <source>The point %1 is told twice: leave one out.</source>
        <translation>A(z) %1 pont kétszer szerepel: hagyja el az egyiket.</translation>
    </message>
    <message>
        <source>The points are too few: this feature needs %1 at least.</source>
        <translation>Túl kevés a pont: legalább %1 kell.</translation>
    </message>
    <message>
        <source>The points fit the faces only if their numbers are %1: correct the unit that the file states.</source>
        <translation>A pontok csak akkor illenek a felületekre, ha számaik %1 egységben értendők: javítsa a fájl mértékegységét.</translation>
    </message>
    <message>
        <source>The points lie up to %1 mm from the part: align them with it first.</source>
        <translation>A pontok akár %1 mm-re vannak a darabtól: előbb igazítsa hozzá őket.</translation>
    </message>
    <message>
        <source>The post-processor &apos;%1&apos; failed (%2): choose another, or mend it.</source>
        <translation>A(z) „%1” posztprocesszor hibára futott (%2): válasszon másikat, vagy javítsa ki.</translation>
    </message>
    <message>
        <source>The post-processor &apos;%1&apos; refuses the arguments &apos;%2&apos;.</source>
        <translation>A(z) „%1” posztprocesszor nem fogadja el az argumentumokat: „%2”.</translation>
    </message>
    <message>
        <source>The pre-drilled hole %1 is too near to a wall to come down in: it was not used.</source>
        <translation>Az előfúrt furat %1 túl közel van egy falhoz a bemerüléshez: nem lett használva.</translation>
    </message>
    <message>
        <source>The pre-drilled hole %1 lies in a narrow passage that is skipped: it was not used.</source>
        <translation>Az előfúrt furat %1 kihagyott szűk helyen van: nem lett használva.</translation>
    </message>
    <message>
        <source>The pre-drilled hole is too tight to start from: drill it wider, or choose the entry &apos;Automatic&apos; or &apos;Helix&apos;.</source>
        <translation>Az előfúrt furat túl szűk a kezdéshez: fúrja nagyobbra, vagy válassza az „Automatikus” vagy a „Csigavonal” bemerülést.</translation>
    </message>
    <message>
        <source>The pre-drilled hole is too tight to start from: it was not used.</source>
        <translation>Az előfúrt furat túl szűk a kezdéshez: nem lett használva.</translation>
    </message>
    <message>
        <source>The pre-drilled hole lies in a narrow passage that is skipped: choose the entry &apos;Automatic&apos;, or another NarrowPassages.</source>
        <translation>Az előfúrt furat kihagyott szűk helyen van: válassza az „Automatikus” bemerülést, vagy mást: [NarrowPassages].</translation>
    </message>
    <message>
        <source>The pre-drilled hole was not used: a spiral around an island begins beside its wall.</source>
        <translation>Az előfúrt furat nem lett használva: a sziget körüli spirál annak fala mellett kezdődik.</translation>
    </message>
    <message>
        <source>The pre-drilled hole was not used: a spiral around an island in open stock comes from outside.</source>
        <translation>Az előfúrt furat nem lett használva: nyitott nyersdarabban a sziget körüli spirál kívülről jön.</translation>
    </message>
    <message>
        <source>The pre-drilled hole&apos;s centre lies outside the ground that the tool can reach: move EntryPoint into the pocket, at least a tool&apos;s radius from its walls.</source>
        <translation>Az előfúrt furat közepe a szerszám által elérhető területen kívül van: helyezze a zsebbe: [EntryPoint], legalább szerszámsugárnyira a falaktól.</translation>
    </message>
    <message>
        <source>The program has several spindle speeds: the lowest, %1 rev/min, was taken.</source>
        <translation>A programban több fordulatszám van: a legkisebb, %1 ford/perc lett véve.</translation>
    </message>
    <message>
        <source>The region %1 does not hold the pre-drilled hole: it has an entry of its own.</source>
        <translation>A terület %1 nem tartalmazza az előfúrt furatot: saját bemerülése van.</translation>
    </message>
    <message>
        <source>The region %1, which does not hold the pre-drilled hole, was left uncut: choose the entry &apos;Automatic&apos;, or drill it and use an operation of its own.</source>
        <translation>A terület %1, amelyben nincs előfúrt furat, kimaratlan maradt: válassza az „Automatikus” bemerülést, vagy fúrja elő, és használjon külön műveletet.</translation>
    </message>
    <message>
        <source>The report is written.</source>
        <translation>A jelentés elkészült.</translation>
    </message>
    <message>
        <source>The resolution is coarser than the stock is wide: choose a finer one.</source>
        <translation>A felbontás durvább, mint a nyersdarab szélessége: válasszon finomabbat.</translation>
    </message>
    <message>
        <source>The response has a gap between %1 and %2 Hz: measure it again, or cut it there.</source>
        <translation>Az átvitelben rés van %1 és %2 Hz között: mérje meg újra, vagy vágja el ott.</translation>
    </message>
    <message>
        <source>The response has a value that is no number.</source>
        <translation>Az átvitel egyik értéke nem szám.</translation>
    </message>
    <message>
        <source>The response has too few lines to look between them.</source>
        <translation>Az átvitelnek túl kevés sora van ahhoz, hogy közéjük nézzünk.</translation>
    </message>
    <message>
        <source>The response has too few lines: at least four are needed.</source>
        <translation>Az átvitelnek túl kevés sora van: legalább négy kell.</translation>
    </message>
    <message>
        <source>The response needs one value for each frequency.</source>
        <translation>Az átvitelhez minden frekvenciához kell érték.</translation>
    </message>
    <message>
        <source>The response needs values of at least one axis, xx or yy.</source>
        <translation>Az átvitelhez legalább egy tengely értékei kellenek, xx vagy yy.</translation>
    </message>
    <message>
        <source>The retract height must be at least %1 mm, above every approach.</source>
        <translation>A visszahúzási magasság legalább %1 mm legyen, minden ráállás felett.</translation>
    </message>
    <message>
        <source>The same of the exponent; evenly or late, as is quicker, where it is empty</source>
        <translation>Ugyanez a kitevőre; üresen egyenletesen vagy későn, amelyik gyorsabb</translation>
    </message>
    <message>
        <source>The same of the second semi-axis</source>
        <translation>Ugyanez a második féltengelyre</translation>
    </message>
    <message>
        <source>The shape has no face.</source>
        <translation>Az alaknak nincs felülete.</translation>
    </message>
    <message>
        <source>The shape is no readable BREP text.</source>
        <translation>Az alak nem olvasható BREP-szöveg.</translation>
    </message>
    <message>
        <source>The side step as a share of the diameter</source>
        <translation>Az oldallépés az átmérő arányában</translation>
    </message>
    <message>
        <source>The simulation was cancelled.</source>
        <translation>A szimuláció megszakadt.</translation>
    </message>
    <message>
        <source>The slot %1 is so little wider than the tool that posts would write the turns of constant engagement as lines with corners: circles are repeated there.</source>
        <translation>A horony %1 alig szélesebb a szerszámnál, ezért a posztprocesszorok az állandó átfogású fordulatokat sarkos egyenesekként írnák: ott körök ismétlődnek.</translation>
    </message>
    <message>
        <source>The slot&apos;s sides meet each other: make the slot narrower, or move the parts of its middle further apart.</source>
        <translation>A horony oldalai összeérnek: tegye keskenyebbé a hornyot, vagy középvonalának részeit távolabb.</translation>
    </message>
    <message>
        <source>The slot&apos;s width must be positive: set SlotWidth.</source>
        <translation>A horony szélessége pozitív legyen: adja meg: [SlotWidth].</translation>
    </message>
    <message>
        <source>The spindle can do none of the chart&apos;s speeds.</source>
        <translation>Az orsó a diagram egyik fordulatszámára sem képes.</translation>
    </message>
    <message>
        <source>The spindle of &apos;%1&apos; does not turn: set its SpindleDir.</source>
        <translation>„%1” orsója nem forog: állítsa be: [SpindleDir].</translation>
    </message>
    <message>
        <source>The spindle of &apos;%1&apos; turns counter-clockwise, as its SpindleDir says: the path goes the other way round, so that it cuts as %2.</source>
        <translation>„%1” orsója az óramutatóval ellentétesen forog ([SpindleDir]): a pálya fordítva halad, így %2 mar.</translation>
    </message>
    <message>
        <source>The spindle turns counter-clockwise: it is simulated as if clockwise.</source>
        <translation>Az orsó az óramutatóval ellentétesen forog: úgy szimuláljuk, mintha azzal egyezően forogna.</translation>
    </message>
    <message>
        <source>The spiral clears only %1 % of this pocket%2.</source>
        <translation>A spirál e zsebnek csak %1 %-át marja ki%2.</translation>
    </message>
    <message>
        <source>The spiral turns more tightly than MinimumRadius, down to %1 mm: raise ExponentStart or ExponentEnd, or make the courses more even.</source>
        <translation>A spirál szűkebben fordul ennél: [MinimumRadius], akár %1 mm-rel: növelje: [ExponentStart] vagy [ExponentEnd], vagy tegye egyenletesebbé a lefutásokat.</translation>
    </message>
    <message>
        <source>The spiral would take more than 2000 turns: raise EngagementAngle or Pitch, make courses more even, or take the operation Adaptive.</source>
        <translation>A spirálhoz több mint 2000 menet kellene: növelje: [EngagementAngle] vagy [Pitch], tegye egyenletesebbé a lefutásokat, vagy használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>The stiffness of a mode must be above 0 N/um.</source>
        <translation>A módus merevsége legyen 0 N/um felett.</translation>
    </message>
    <message>
        <source>The stock &apos;%1&apos; cannot be read: %2.</source>
        <translation>A(z) „%1” nyersdarab nem olvasható: %2.</translation>
    </message>
    <message>
        <source>The stock &apos;%1&apos; is empty: give the job another one.</source>
        <translation>A(z) „%1” nyersdarab üres: adjon másikat a feladatnak.</translation>
    </message>
    <message>
        <source>The stock does not contain the part: %1 mm2 of it lie outside; enlarge the stock.</source>
        <translation>A nyersdarab nem tartalmazza a darabot: %1 mm2 kívül esik; növelje meg a nyersdarabot.</translation>
    </message>
    <message>
        <source>The stock would need too many dexels: choose a coarser resolution.</source>
        <translation>A nyersdarabhoz túl sok dexel kellene: válasszon durvább felbontást.</translation>
    </message>
    <message>
        <source>The stock&apos;s top must lie above its bottom.</source>
        <translation>A nyersdarab teteje az alja felett legyen.</translation>
    </message>
    <message>
        <source>The text of the modes is no JSON: %1.</source>
        <translation>A módusok szövege nem JSON: %1.</translation>
    </message>
    <message>
        <source>The tolerance must be above 0 mm.</source>
        <translation>A tűrés legyen 0 mm felett.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not cut at its centre and cannot enter by a ramp near (%2, %3): set a pre-drilled hole, or take a tool that cuts at its centre.</source>
        <translation>A(z) „%1” szerszám közepe nem vág, és rámpán nem merülhet be itt: (%2, %3): adjon meg előfúrt furatot, vagy vegyen középen vágó szerszámot.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not say its %2: stability is that of %3.</source>
        <translation>A(z) „%1” szerszám nem adja meg: %2; a stabilitás ehhez tartozik: %3.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not say its %2: the force is that of %3.</source>
        <translation>A(z) „%1” szerszám nem adja meg: %2; az erő ehhez tartozik: %3.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; is %2: choose %3 end mill.</source>
        <translation>A(z) „%1” szerszám %2: válasszon ujjmarót: %3.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; is simulated with sharp corners.</source>
        <translation>A(z) „%1” szerszámot éles sarkokkal szimuláljuk.</translation>
    </message>
    <message>
        <source>The tool controller &apos;%1&apos; has no modes: give them, or load a tap test in the window Stability chart.</source>
        <translation>A(z) „%1” szerszámvezérlőnek nincsenek módusai: adja meg őket, vagy töltsön be mérést a Stabilitási térkép ablakban.</translation>
    </message>
    <message>
        <source>The tool controller &apos;%1&apos; has no tool: choose one for it.</source>
        <translation>A(z) „%1” szerszámvezérlőnek nincs szerszáma: válasszon egyet.</translation>
    </message>
    <message>
        <source>The tool controller has no spindle speed: there is no chip thickness.</source>
        <translation>A szerszámvezérlőnek nincs fordulatszáma: nincs forgácsvastagság.</translation>
    </message>
    <message>
        <source>The tool has no room to descend in this pocket: drill a hole first and choose the entry &apos;Predrilled hole&apos;, or take a smaller tool.</source>
        <translation>A szerszámnak nincs helye bemerülni ebben a zsebben: előbb fúrjon furatot, és válassza az „Előfúrt furat” bemerülést, vagy vegyen kisebb szerszámot.</translation>
    </message>
    <message>
        <source>The triangles of &apos;%1&apos; leave it by %2 mm, too much for the Tolerance of %3 mm: raise it.</source>
        <translation>„%1” háromszögei %2 mm-rel térnek el, ez túl sok: [Tolerance] %3 mm: növelje.</translation>
    </message>
    <message>
        <source>The trochoid&apos;s shape; the circular and the cycloid one reach the engagement angle only for a moment of each turn</source>
        <translation>A trochoid alakja; a körös és a cikloisos csak egy pillanatra éri el az átfogási szöget minden fordulatban</translation>
    </message>
    <message>
        <source>The unit of %1 is unknown: name it, as unit=&apos;m/N&apos;; there are %2.</source>
        <translation>%1 mértékegysége ismeretlen: adja meg, például unit=&apos;m/N&apos;; lehetséges: %2.</translation>
    </message>
    <message>
        <source>The work plane &apos;%1&apos; is turned, and EvenLoad cuts along the job&apos;s own axes: choose another, or turn the model in a job of its own.</source>
        <translation>A(z) „%1” munkasík el van forgatva, az EvenLoad pedig a feladat tengelyei mentén mar: válasszon másikat, vagy fordítsa el a modellt külön feladatban.</translation>
    </message>
    <message>
        <source>There is neither a face nor an edge to work on: pick a face or a sketch.</source>
        <translation>Nincs megmunkálható felület vagy él: jelöljön ki felületet vagy vázlatot.</translation>
    </message>
    <message>
        <source>There is no %1 on %2: pick the faces anew.</source>
        <translation>%2: nincs rajta %1: jelölje ki újra a felületeket.</translation>
    </message>
    <message>
        <source>There is no %1 on %2: pick the geometry anew.</source>
        <translation>%2: nincs rajta %1: jelölje ki újra a geometriát.</translation>
    </message>
    <message>
        <source>There is no machine &apos;%1&apos;: choose one of %2, or give a JSON file or a dictionary of limits.</source>
        <translation>Nincs „%1” gép: válasszon ezek közül: %2, vagy adjon meg JSON-fájlt vagy határok szótárát.</translation>
    </message>
    <message>
        <source>There is no material &apos;%1&apos;: choose one of %2, or give a JSON file or a dictionary with ktc and krc.</source>
        <translation>Nincs „%1” anyag: válasszon ezek közül: %2, vagy adjon meg JSON-fájlt vagy szótárt ktc és krc értékkel.</translation>
    </message>
    <message>
        <source>There is no post-processor &apos;%1&apos;: this FreeCAD has %2.</source>
        <translation>Nincs „%1” posztprocesszor: ebben a FreeCAD-ben van: %2.</translation>
    </message>
    <message>
        <source>This FreeCAD has %1, EvenLoad&apos;s compiled modules are for %2: %3</source>
        <translation>Ebben a FreeCAD-ben %1 van, az EvenLoad lefordított moduljai ehhez valók: %2: %3</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Idő</translation>
    </message>
    <message>
        <source>Time %s</source>
        <translation>Idő %s</translation>
    </message>
    <message>
        <source>Times are within its limits</source>
        <translation>Az idők a gép határain belül értendők</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Eddig</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tűrés</translation>
    </message>
    <message>
        <source>Tool centre</source>
        <translation>Szerszámközéppont</translation>
    </message>
    <message>
        <source>Tool contact</source>
        <translation>Érintési pont</translation>
    </message>
    <message>
        <source>Tool controller</source>
        <translation>Szerszámvezérlő</translation>
    </message>
    <message>
        <source>Trochoid with smaller radius</source>
        <translation>Trochoid kisebb sugárral</translation>
    </message>
    <message>
        <source>Turned more tightly than the wished %1 mm in %2, down to %3 mm %4.</source>
        <translation>A kívánt %1 mm-nél szűkebb fordulás: %2, akár %3 mm %4.</translation>
    </message>
    <message>
        <source>Two islands cross or touch near (%1, %2): move them apart in the sketch, or join them into one curve.</source>
        <translation>Két sziget metszi vagy érinti egymást itt: (%1, %2): távolítsa el őket egymástól a vázlatban, vagy egyesítse egy görbévé.</translation>
    </message>
    <message>
        <source>Two outlines cross or touch: keep them apart, or draw what they enclose together as one.</source>
        <translation>Két körvonal metszi vagy érinti egymást: tartsa távol őket, vagy rajzolja meg egyként, amit együtt bezárnak.</translation>
    </message>
    <message>
        <source>Uncut %s</source>
        <translation>Maradék %s</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Mértékegység</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Érvényes</translation>
    </message>
    <message>
        <source>Valid, checked against the model</source>
        <translation>Érvényes, a modellel ellenőrizve</translation>
    </message>
    <message>
        <source>Vert. Feed</source>
        <translation>Függ. előtolás</translation>
    </message>
    <message>
        <source>Vibration at the tool&apos;s tip</source>
        <translation>Rezgés a szerszám csúcsán</translation>
    </message>
    <message>
        <source>Wall pass</source>
        <translation>Fal menti fogás</translation>
    </message>
    <message>
        <source>What earlier operations left in narrow passages is cut by trochoids, not at a reduced feed.</source>
        <translation>Amit a korábbi műveletek szűk helyeken hagytak, trochoidok marják ki, nem csökkentett előtolás.</translation>
    </message>
    <message>
        <source>What has to lie on the picked faces while the tool cuts: the point where it touches, or its axis seen from above</source>
        <translation>Minek kell a kijelölt felületeken lennie, amíg a szerszám vág: az érintési pontnak, vagy a tengelynek felülnézetben</translation>
    </message>
    <message>
        <source>What is cut; only Constant force asks for it</source>
        <translation>Amit marnak; csak az állandó erőhöz kell</translation>
    </message>
    <message>
        <source>What is done where the width left for the tool&apos;s centre is under twice MinimumRadius</source>
        <translation>Mi történjen ott, ahol a szerszámközéppontnak maradó szélesség a legkisebb sugár kétszerese alatt van</translation>
    </message>
    <message>
        <source>What must stay of the model is not known: %1.</source>
        <translation>Nem ismert, minek kell megmaradnia a modellből: %1.</translation>
    </message>
    <message>
        <source>What stands above %1 mm could not be found (%2)</source>
        <translation>Nem volt meghatározható, mi áll %1 mm felett (%2)</translation>
    </message>
    <message>
        <source>What stays above FinalDepth</source>
        <translation>Ami a végső mélység felett marad</translation>
    </message>
    <message>
        <source>What stays at the walls</source>
        <translation>Ami a falakon marad</translation>
    </message>
    <message>
        <source>What stays on the whole part, measured across its surface</source>
        <translation>Ami az egész darabon marad, a felületre merőlegesen mérve</translation>
    </message>
    <message>
        <source>What stays the same where the engagement is below its target</source>
        <translation>Mi marad azonos ott, ahol az átfogás a célja alatt van</translation>
    </message>
    <message>
        <source>What the spiral does not reach: cleared at constant engagement, or left</source>
        <translation>Amit a spirál nem ér el: állandó átfogással kimarva vagy meghagyva</translation>
    </message>
    <message>
        <source>What was set shall follow the geometry again</source>
        <translation>Amit beállítottak, kövesse ismét a geometriát</translation>
    </message>
    <message>
        <source>Where the feed control would change the feed so often that a program has more blocks per metre of path, it changes it less often, for up to 4 % more time, but not along repeated trochoids or with a least load: for controllers that take few blocks; 0: no limit</source>
        <translation>Ahol a vezérlés olyan gyakran változtatná az előtolást, hogy a programban méterenként több mondat lenne, ritkábban változtatja, legfeljebb 4 % többletidővel, de ismételt trochoidok mentén vagy legkisebb terhelésnél nem: kevés mondatot fogadó vezérlőkhöz; 0: nincs határ</translation>
    </message>
    <message>
        <source>Where to measure</source>
        <translation>Mérési helyek</translation>
    </message>
    <message>
        <source>Wherever the feed is below MaximumFeed, what the feed control holds is at least this share of its nominal value, as far as moves can be divided: less time, more blocks; 0 to 0.95</source>
        <translation>Ahol az előtolás a legnagyobb alatt van, a vezérelt érték legalább ekkora része a névlegesnek, amennyire a mozgások oszthatók: kevesebb idő, több mondat; 0 és 0.95 között</translation>
    </message>
    <message>
        <source>Whether the cut is stable is not known: %1</source>
        <translation>Nem ismert, hogy a fogás stabil-e: %1</translation>
    </message>
    <message>
        <source>Which way the cutting edges meet the material, whichever way the spindle turns</source>
        <translation>Hogyan érik az élek az anyagot, bármerre forog is az orsó</translation>
    </message>
    <message>
        <source>Whole Time</source>
        <translation>Teljes idő</translation>
    </message>
    <message>
        <source>Whose path is simulated</source>
        <translation>Amelynek pályáját szimulálja</translation>
    </message>
    <message>
        <source>Width of the slot round a sketch or edges, which are its centreline once this is set; faces have their own</source>
        <translation>A horony szélessége vázlat vagy élek körül, amelyek ekkor a középvonalai; a felületeknek saját szélességük van</translation>
    </message>
    <message>
        <source>Width of the zone that is allowed</source>
        <translation>A megengedett zóna szélessége</translation>
    </message>
    <message>
        <source>Wished radius of roll-in and roll-out; at first 0.15 of the tool&apos;s diameter</source>
        <translation>A be- és kigördülés kívánt sugara; kezdetben a szerszámátmérő 0.15-szorosa</translation>
    </message>
    <message>
        <source>Wished smallest radius of the path; at first 0.15 of the tool&apos;s diameter</source>
        <translation>A pálya kívánt legkisebb sugara; kezdetben a szerszámátmérő 0.15-szorosa</translation>
    </message>
    <message>
        <source>Writes G-code that probes these points, G38.2, by the post-processor</source>
        <translation>Ezeket a pontokat letapogató G-kódot ír, G38.2, a posztprocesszorral</translation>
    </message>
    <message>
        <source>Writes a report to print, HTML</source>
        <translation>Nyomtatható jelentést ír, HTML</translation>
    </message>
    <message>
        <source>Writes all samples, CSV</source>
        <translation>Minden mintát kiír, CSV</translation>
    </message>
    <message>
        <source>Writes the modes to a file, for other tools and jobs</source>
        <translation>A módusokat fájlba írja, más szerszámokhoz és feladatokhoz</translation>
    </message>
    <message>
        <source>Writes these points as CSV or DMIS</source>
        <translation>CSV- vagy DMIS-fájlba írja a pontokat</translation>
    </message>
    <message>
        <source>Zig-zag</source>
        <translation>Cikcakk</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zóna</translation>
    </message>
    <message>
        <source>a V bit</source>
        <translation>V-alakú gravírozó</translation>
    </message>
    <message>
        <source>a ball end mill</source>
        <translation>gömbvégű maró</translation>
    </message>
    <message>
        <source>a ball end, bull-nosed or flat</source>
        <translation>gömbvégű, sarokrádiuszos vagy sík végű</translation>
    </message>
    <message>
        <source>a chamfering tool</source>
        <translation>élletörő szerszám</translation>
    </message>
    <message>
        <source>a corner-rounding tool</source>
        <translation>saroklekerekítő szerszám</translation>
    </message>
    <message>
        <source>a dovetail cutter</source>
        <translation>fecskefarokmaró</translation>
    </message>
    <message>
        <source>a drill</source>
        <translation>fúró</translation>
    </message>
    <message>
        <source>a flat or bull-nosed</source>
        <translation>sík végű vagy sarokrádiuszos</translation>
    </message>
    <message>
        <source>a helix of %1 degrees</source>
        <translation>%1 fokos horonyemelkedés</translation>
    </message>
    <message>
        <source>a probe</source>
        <translation>tapintó</translation>
    </message>
    <message>
        <source>a reamer</source>
        <translation>dörzsár</translation>
    </message>
    <message>
        <source>a slitting saw</source>
        <translation>hasítófűrész</translation>
    </message>
    <message>
        <source>a tap</source>
        <translation>menetfúró</translation>
    </message>
    <message>
        <source>a tapered ball end mill</source>
        <translation>kúpos gömbvégű maró</translation>
    </message>
    <message>
        <source>a thread mill</source>
        <translation>menetmaró</translation>
    </message>
    <message>
        <source>all lines</source>
        <translation>minden sor</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>X mentén</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>Y mentén</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>ahogy a fájlban</translation>
    </message>
    <message>
        <source>as is quicker</source>
        <translation>ami gyorsabb</translation>
    </message>
    <message>
        <source>build EvenLoad for it with &apos;./run install&apos; in its source tree (README.md).</source>
        <translation>építse meg hozzá az EvenLoadot a forrásfájában a „./run install” paranccsal (README.md).</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>egyenirányban</translation>
    </message>
    <message>
        <source>constant engagement</source>
        <translation>állandó átfogás</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>ellenirányban</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>fogás</translation>
    </message>
    <message>
        <source>cut above %s</source>
        <translation>fogás %s felett</translation>
    </message>
    <message>
        <source>cuts</source>
        <translation>fogások</translation>
    </message>
    <message>
        <source>cylindricity</source>
        <translation>hengeresség</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>mélység</translation>
    </message>
    <message>
        <source>drills from Z%1 up to Z%2: correct its R.</source>
        <translation>Z%1 helyről felfelé fúr Z%2 helyre: javítsa R értékét.</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>bemerülések</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>bemerülés</translation>
    </message>
    <message>
        <source>evenly</source>
        <translation>egyenletesen</translation>
    </message>
    <message>
        <source>flatness</source>
        <translation>síklapúság</translation>
    </message>
    <message>
        <source>from the face</source>
        <translation>a felületé</translation>
    </message>
    <message>
        <source>has a number that is not finite: compute the operation anew.</source>
        <translation>nem véges számot tartalmaz: számítsa újra a műveletet.</translation>
    </message>
    <message>
        <source>has a second G word, which is lost: give that a line of its own.</source>
        <translation>második G szava elvész: adjon neki külön sort.</translation>
    </message>
    <message>
        <source>has no depth of peck: give it Q.</source>
        <translation>nincs fogásmélysége: adja meg Q értékét.</translation>
    </message>
    <message>
        <source>has no radius: give it I and J.</source>
        <translation>nincs sugara: adja meg I és J értékét.</translation>
    </message>
    <message>
        <source>helix angle</source>
        <translation>horonyemelkedési szög</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>vízszintes</translation>
    </message>
    <message>
        <source>in tolerance</source>
        <translation>tűrésen belül</translation>
    </message>
    <message>
        <source>is an arc whose radii at its ends are %1 and %2 mm: correct its I and J.</source>
        <translation>olyan ív, amelynek sugara a végein %1 és %2 mm: javítsa I és J értékét.</translation>
    </message>
    <message>
        <source>is no G-code: leave it out.</source>
        <translation>nem G-kód: hagyja el.</translation>
    </message>
    <message>
        <source>is not known to the simulator: leave it out.</source>
        <translation>ismeretlen a szimulátornak: hagyja el.</translation>
    </message>
    <message>
        <source>link</source>
        <translation>átkötés</translation>
    </message>
    <message>
        <source>links</source>
        <translation>átkötések</translation>
    </message>
    <message>
        <source>lower the step down below %1 mm</source>
        <translation>csökkentse a fogásmélységet %1 mm alá</translation>
    </message>
    <message>
        <source>lower the step down below %1 mm or turn the spindle at %2 rev/min</source>
        <translation>csökkentse a fogásmélységet %1 mm alá, vagy járassa az orsót %2 ford/perccel</translation>
    </message>
    <message>
        <source>magnitude-phase</source>
        <translation>nagyság és fázis</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>pozitív legyen</translation>
    </message>
    <message>
        <source>must lie between %1 and %2%3</source>
        <translation>%1 és %2%3 közé essen</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>nem lehet negatív</translation>
    </message>
    <message>
        <source>narrow places</source>
        <translation>szűk helyeken</translation>
    </message>
    <message>
        <source>narrow places of %1 rooms</source>
        <translation>%1 rész szűk helyein</translation>
    </message>
    <message>
        <source>near (%1, %2)</source>
        <translation>itt: (%1, %2)</translation>
    </message>
    <message>
        <source>near (%1, %2, %3)</source>
        <translation>itt: (%1, %2, %3)</translation>
    </message>
    <message>
        <source>no end mill</source>
        <translation>nem ujjmaró</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>nincs határ</translation>
    </message>
    <message>
        <source>no straight cylinder</source>
        <translation>nem egyenes henger</translation>
    </message>
    <message>
        <source>no tool does, lower StockToLeave.</source>
        <translation>egyik sem, csökkentse: [StockToLeave].</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nincs</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nem eldöntött</translation>
    </message>
    <message>
        <source>number of teeth</source>
        <translation>fogszám</translation>
    </message>
    <message>
        <source>number of teeth and its helix angle</source>
        <translation>fogszám és horonyemelkedési szög</translation>
    </message>
    <message>
        <source>of the type %1</source>
        <translation>%1 típusú</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>tűrésen kívül</translation>
    </message>
    <message>
        <source>point beyond the tolerance</source>
        <translation>tűrésen kívüli pont</translation>
    </message>
    <message>
        <source>points of contact</source>
        <translation>érintési pontok</translation>
    </message>
    <message>
        <source>profile of a surface</source>
        <translation>felület profilja</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>gyorsjárat</translation>
    </message>
    <message>
        <source>rapids</source>
        <translation>gyorsjáratok</translation>
    </message>
    <message>
        <source>real-imaginary</source>
        <translation>valós és képzetes rész</translation>
    </message>
    <message>
        <source>rev/min</source>
        <translation>ford/perc</translation>
    </message>
    <message>
        <source>roundness</source>
        <translation>köralak</translation>
    </message>
    <message>
        <source>sphericity</source>
        <translation>gömbalak</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>fordulatszám</translation>
    </message>
    <message>
        <source>straightness</source>
        <translation>egyenesség</translation>
    </message>
    <message>
        <source>that side</source>
        <translation>ez az oldal</translation>
    </message>
    <message>
        <source>the largest tool that fits has %1 mm.</source>
        <translation>a legnagyobb beleférő szerszám %1 mm-es.</translation>
    </message>
    <message>
        <source>the user&apos;s machine</source>
        <translation>saját gép</translation>
    </message>
    <message>
        <source>the user&apos;s material</source>
        <translation>saját anyag</translation>
    </message>
    <message>
        <source>the user&apos;s modes</source>
        <translation>saját módusok</translation>
    </message>
    <message>
        <source>these sides</source>
        <translation>ezek az oldalak</translation>
    </message>
    <message>
        <source>turns the work: only paths with a fixed tool axis can be simulated.</source>
        <translation>elforgatja a munkadarabot: csak rögzített szerszámtengelyű pálya szimulálható.</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>függőleges</translation>
    </message>
    <message>
        <source>where earlier cuts left the material in pieces of any shape</source>
        <translation>ahol a korábbi fogások tetszőleges alakú anyagdarabokat hagytak</translation>
    </message>
    <message>
        <source>where no ground for a first period could be cleared</source>
        <translation>ahol az első periódushoz nem volt kimarható hely</translation>
    </message>
    <message>
        <source>where no walls stay equally far apart, straight or as arcs about one centre, for as long as the slot is wide</source>
        <translation>ahol a falak, egyenesen vagy egy középpont körüli ívként, nem maradnak egyenlő távol legalább a horony szélességén</translation>
    </message>
    <message>
        <source>where the slot is too short for a few periods</source>
        <translation>ahol a horony néhány periódushoz túl rövid</translation>
    </message>
    <message>
        <source>where the tool has too little room to turn in the slot</source>
        <translation>ahol a szerszámnak túl kevés helye van fordulni a horonyban</translation>
    </message>
    <message>
        <source>where the walls are more than four tool diameters apart</source>
        <translation>ahol a falak négy szerszámátmérőnél távolabb vannak</translation>
    </message>
    <message>
        <source>without a diameter</source>
        <translation>átmérő nélküli</translation>
    </message>
    <message>
        <source>○ as it is   ● as chosen</source>
        <translation>○ mostani   ● választott</translation>
    </message>
    <message>
        <source>%s: error %.1f %%</source>
        <translation>%s: hiba %.1f %%</translation>
    </message>
    <message>
        <source>The document &apos;%1&apos; has no 3D view: open one.</source>
        <translation>A(z) „%1” dokumentumnak nincs 3D nézete: nyisson egyet.</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>illesztett</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>frekvencia, Hz</translation>
    </message>
    <message>
        <source>imaginary part of %s, µm/N</source>
        <translation>%s képzetes része, µm/N</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>határ</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mért</translation>
    </message>
    <message>
        <source>no material, no force</source>
        <translation>nincs anyag, nincs erő</translation>
    </message>
    <message>
        <source>real part of %s, µm/N</source>
        <translation>%s valós része, µm/N</translation>
    </message>
    <message>
        <source>spindle speed, rev/min</source>
        <translation>fordulatszám, ford/perc</translation>
    </message>
    <message>
        <source>time on the machine, s</source>
        <translation>idő a gépen, s</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>idő, s</translation>
    </message>
    <message>
        <source>A Lamé spiral cannot clear what earlier operations left: turn UseRestMachining off, or take the operation Adaptive.</source>
        <translation>A Lamé-spirál nem tudja kimarni, amit korábbi műveletek meghagytak: kapcsolja ki: [UseRestMachining], vagy használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>The points all lie in one place: a line needs two places at least.</source>
        <translation>Minden pont egy helyen van: egyeneshez legalább két hely kell.</translation>
    </message>
    <message>
        <source>The points do not determine a cylinder: measure it at two heights and all around, or over as much of it as there is.</source>
        <translation>A pontok nem határoznak meg hengert: mérje két magasságban és körben, vagy amekkora részén lehet.</translation>
    </message>
    <message>
        <source>The points lie in one plane or on one circle: a sphere needs points beside it.</source>
        <translation>A pontok egy síkban vagy egy körön vannak: gömbhöz mellette is kell pont.</translation>
    </message>
    <message>
        <source>The points lie on one line, or in two places: a circle needs three places off a line.</source>
        <translation>A pontok egy egyenesen vagy két helyen vannak: körhöz három, nem egy egyenesre eső hely kell.</translation>
    </message>
    <message>
        <source>The points lie on one line: a plane needs points beside it.</source>
        <translation>A pontok egy egyenesen vannak: síkhoz mellette is kell pont.</translation>
    </message>
    <message>
        <source>The resolution must be positive, in mm.</source>
        <translation>A felbontás pozitív legyen, mm.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle bends more tightly than half the slot&apos;s width: make the slot narrower, or bend it less.</source>
        <translation>A horony középvonala a fél szélességnél szűkebben hajlik: tegye keskenyebbé a hornyot, vagy hajlítsa kevésbé.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle crosses itself: divide it into slots that do not.</source>
        <translation>A horony középvonala metszi önmagát: ossza fel olyan hornyokra, amelyeké nem.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle has no length: draw a line or an arc along the slot.</source>
        <translation>A horony középvonalának nincs hossza: rajzoljon egyenest vagy ívet a horony mentén.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle must have finite coordinates.</source>
        <translation>A horony középvonalának koordinátái végesek legyenek.</translation>
    </message>
    <message>
        <source>The stock has no region: give it one.</source>
        <translation>A nyersdarabnak nincs területe: adjon neki egyet.</translation>
    </message>
    <message>
        <source>The stock has no upper side: give it one.</source>
        <translation>A nyersdarabnak nincs felső oldala: adjon neki egyet.</translation>
    </message>
    <message>
        <source>The stock&apos;s top and bottom must be numbers, in mm.</source>
        <translation>A nyersdarab teteje és alja szám legyen, mm.</translation>
    </message>
    <message>
        <source>The region near (%1, %2): %3</source>
        <translation>A terület itt: (%1, %2): %3</translation>
    </message>
    <message>
        <source>%1 chatters %2 mm deep at %3 rev/min and %4°, where the feed is at %5° to X.</source>
        <translation>%1 berezeg %2 mm mélyen, %3 ford/perc és %4° mellett, ahol az előtolás iránya %5° az X-hez.</translation>
    </message>
    <message>
        <source>%1 mm is deeper than the cutting length of %2, %3 mm.</source>
        <translation>%1 mm mélyebb, mint a vágóhossz (%2): %3 mm.</translation>
    </message>
    <message>
        <source>%1 nearly chatters %2 mm deep at %3 rev/min and %4°, where the feed is at %5° to X.</source>
        <translation>%1 majdnem berezeg %2 mm mélyen, %3 ford/perc és %4° mellett, ahol az előtolás iránya %5° az X-hez.</translation>
    </message>
    <message>
        <source>%1 of %2 places along the path are not counted: the tool is at an edge or border there, or takes no chip that is known.</source>
        <translation>A pálya %2 helyéből %1 nem számít: a szerszám ott élen vagy peremen van, vagy nem vesz le ismert forgácsot.</translation>
    </message>
    <message>
        <source>%1 of the tool controller &apos;%2&apos; cannot be read: empty it.</source>
        <translation>A(z) „%2” szerszámvezérlőben ez nem olvasható: %1: ürítse ki.</translation>
    </message>
    <message>
        <source>%1 rev/min is outside of what %2 and the machine can do, %3 to %4 rev/min.</source>
        <translation>%1 ford/perc kívül esik azon, amire a szerszám (%2) és a gép képes, %3 és %4 ford/perc között.</translation>
    </message>
    <message>
        <source>%s cuts by %s.</source>
        <translation>%s marási módja: %s.</translation>
    </message>
    <message>
        <source>A click on the rim or the wall of a hole in the 3D view takes its centre and diameter, one elsewhere the place alone</source>
        <translation>Kattintás egy furat peremére vagy falára a 3D nézetben a közepét és átmérőjét veszi át, máshová csak a helyet</translation>
    </message>
    <message>
        <source>A flat end mill leaves steps, not cusps: set a stepover, or take a ball end mill.</source>
        <translation>A lapos végű maró lépcsőket hagy, nem barázdákat: adjon meg sortávot, vagy vegyen gömbvégű marót.</translation>
    </message>
    <message>
        <source>A guide has no length: pick another edge.</source>
        <translation>Egy vezetővonalnak nincs hossza: válasszon másik élt.</translation>
    </message>
    <message>
        <source>A number for finishing is not finite.</source>
        <translation>A simítás egyik száma nem véges.</translation>
    </message>
    <message>
        <source>A patch needs two curvatures in 1/mm, a slope from 0 to below 90 degrees and the direction in which it leans.</source>
        <translation>Egy felületdarabhoz két görbület kell 1/mm-ben, 0 és 90 fok közötti lejtés, és a lejtés iránya.</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Igazítás</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Mind</translation>
    </message>
    <message>
        <source>All figures are at a constant feed, for a constant force does not scale.</source>
        <translation>Minden szám állandó előtolásra vonatkozik, mert az állandó erő nem számítható át.</translation>
    </message>
    <message>
        <source>All figures are of whole floors, as if nothing had been cut before.</source>
        <translation>Minden szám teljes fenékre vonatkozik, mintha előtte semmi sem lett volna kimarva.</translation>
    </message>
    <message>
        <source>All figures are those of EvenLoad Adaptive on the same floors.</source>
        <translation>Minden szám az EvenLoad adaptív műveleté ugyanezen a fenéken.</translation>
    </message>
    <message>
        <source>All figures are without the stock to leave at the walls.</source>
        <translation>Minden szám a falak ráhagyása nélkül értendő.</translation>
    </message>
    <message>
        <source>Angle, °</source>
        <translation>Szög, °</translation>
    </message>
    <message>
        <source>Angles are numbers between 0 and 180, as 45; 60; 75.</source>
        <translation>A szögek 0 és 180 közötti számok, például 45; 60; 75.</translation>
    </message>
    <message>
        <source>Angles, °</source>
        <translation>Szögek, °</translation>
    </message>
    <message>
        <source>At its end</source>
        <translation>A végénél</translation>
    </message>
    <message>
        <source>At the least chip of %1 mm %2 of the tool of %3 mm at %4°, %5 mm deep, is above %6.</source>
        <translation>A legkisebb, %1 mm-es forgácsnál ez: %2 nagyobb, mint %6 (%3 mm-es szerszám %4° mellett, %5 mm mélyen).</translation>
    </message>
    <message>
        <source>Between guides</source>
        <translation>Vezetővonalak között</translation>
    </message>
    <message>
        <source>Blue to white</source>
        <translation>Kéktől fehérig</translation>
    </message>
    <message>
        <source>Chatter is not looked at: the tool has no modes of it.</source>
        <translation>A berezgést nem vizsgáljuk: a szerszámnak nincsenek hozzá módusai.</translation>
    </message>
    <message>
        <source>Chip, %s</source>
        <translation>Forgács, %s</translation>
    </message>
    <message>
        <source>Chosen…</source>
        <translation>Választott…</translation>
    </message>
    <message>
        <source>Colours of values</source>
        <translation>Értékek színei</translation>
    </message>
    <message>
        <source>Concave</source>
        <translation>Homorú</translation>
    </message>
    <message>
        <source>Convex</source>
        <translation>Domború</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Vágóhossz</translation>
    </message>
    <message>
        <source>Datum</source>
        <translation>Bázis</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes</source>
        <translation>Szomszédos sorok távolsága</translation>
    </message>
    <message>
        <source>Engagement angles in degrees</source>
        <translation>Átfogási szögek fokban</translation>
    </message>
    <message>
        <source>EvenLoad Finishing Advisor</source>
        <translation>EvenLoad simítási tanácsadó</translation>
    </message>
    <message>
        <source>EvenLoad Optimise</source>
        <translation>EvenLoad optimalizálás</translation>
    </message>
    <message>
        <source>EvenLoad Optimise: %s</source>
        <translation>EvenLoad optimalizálás: %s</translation>
    </message>
    <message>
        <source>Face radius</source>
        <translation>Felület sugara</translation>
    </message>
    <message>
        <source>Feed direction</source>
        <translation>Előtolás iránya</translation>
    </message>
    <message>
        <source>Feed direction and Rz must be numbers, and Rz not below 0.</source>
        <translation>Az előtolás iránya és az Rz szám legyen, és az Rz ne legyen 0 alatt.</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Fogankénti előtolás</translation>
    </message>
    <message>
        <source>Feed, %s/min</source>
        <translation>Előtolás, %s/min</translation>
    </message>
    <message>
        <source>Feeds must be positive.</source>
        <translation>Az előtolás legyen pozitív.</translation>
    </message>
    <message>
        <source>Fewer paths are computed, which is quicker</source>
        <translation>Kevesebb pályát számít, ez gyorsabb</translation>
    </message>
    <message>
        <source>Finds the quickest cut that keeps these limits</source>
        <translation>Megkeresi a leggyorsabb fogást e határokon belül</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Simítás</translation>
    </message>
    <message>
        <source>Free motions</source>
        <translation>Szabad mozgások</translation>
    </message>
    <message>
        <source>From the least value to the largest</source>
        <translation>A legkisebb értéktől a legnagyobbig</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Általános</translation>
    </message>
    <message>
        <source>Gives the operation the chosen strategy</source>
        <translation>A kiválasztott stratégiát állítja be a műveletben</translation>
    </message>
    <message>
        <source>Height of what stands between two passes</source>
        <translation>Ami két sor között megmarad, annak magassága</translation>
    </message>
    <message>
        <source>Highest cusp</source>
        <translation>Legmagasabb barázda</translation>
    </message>
    <message>
        <source>How it is bent</source>
        <translation>Hogyan görbül</translation>
    </message>
    <message>
        <source>How many cutting edges it has around</source>
        <translation>Hány éle van a kerületén</translation>
    </message>
    <message>
        <source>How many numbers of levels, from the fewest possible on</source>
        <translation>Hányféle szintszám, a lehető legkisebbtől kezdve</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>Erőimpulzus</translation>
    </message>
    <message>
        <source>In the window; the setup sheet of a job comes first. Macros and job files begin with the same values for everyone</source>
        <translation>Az ablakban; a munka beállítólapja elsőbbséget élvez. A makrók és munkafájlok mindenkinél ugyanazokkal az értékekkel kezdenek</translation>
    </message>
    <message>
        <source>It exceeds the tolerance of %1.</source>
        <translation>A(z) %1 tűrést túllépi.</translation>
    </message>
    <message>
        <source>It keeps the tolerance of %1.</source>
        <translation>A(z) %1 tűrést betartja.</translation>
    </message>
    <message>
        <source>Its times, largest feed and spindle</source>
        <translation>A gép idői, legnagyobb előtolása és orsója</translation>
    </message>
    <message>
        <source>Its tool must have a ball end</source>
        <translation>A szerszámának gömbvégűnek kell lennie</translation>
    </message>
    <message>
        <source>Keep the angle</source>
        <translation>A szög marad</translation>
    </message>
    <message>
        <source>Keep the step down</source>
        <translation>A fogásmélység marad</translation>
    </message>
    <message>
        <source>Largest cutting force that tool and clamping stand</source>
        <translation>A legnagyobb forgácsolóerő, amelyet szerszám és befogás elvisel</translation>
    </message>
    <message>
        <source>Largest power; the machine&apos;s own holds besides</source>
        <translation>Legnagyobb teljesítmény; emellett a gépé is érvényes</translation>
    </message>
    <message>
        <source>Largest torque; the machine&apos;s own holds besides</source>
        <translation>Legnagyobb nyomaték; emellett a gépé is érvényes</translation>
    </message>
    <message>
        <source>Lead radius</source>
        <translation>Rá-/lefutási sugár</translation>
    </message>
    <message>
        <source>Least speed</source>
        <translation>Legkisebb sebesség</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Szintek</translation>
    </message>
    <message>
        <source>Limits of a tool</source>
        <translation>Egy szerszám határai</translation>
    </message>
    <message>
        <source>Make Operation</source>
        <translation>Művelet létrehozása</translation>
    </message>
    <message>
        <source>Makes an operation EvenLoad Finishing of the chosen strategy</source>
        <translation>EvenLoad simítás műveletet hoz létre a kiválasztott stratégiával</translation>
    </message>
    <message>
        <source>Mean cusp</source>
        <translation>Átlagos barázda</translation>
    </message>
    <message>
        <source>Mean thickness</source>
        <translation>Átlagos vastagság</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mért</translation>
    </message>
    <message>
        <source>Measured; an operation tells the height of its cusps, the least that it can be</source>
        <translation>Mért; a művelet a barázdái magasságát adja meg, a lehető legkisebbet</translation>
    </message>
    <message>
        <source>New operations begin with</source>
        <translation>Az új műveletek kezdőértékei</translation>
    </message>
    <message>
        <source>No candidate is within the limits: %1 refuses most, %2 of %3, as in: %4</source>
        <translation>Egyik jelölt sem fér a határok közé: leginkább ez zár ki: %1, %3 közül %2 jelöltet, például: %4</translation>
    </message>
    <message>
        <source>No chip: earlier passes left no stock where the tool stands.</source>
        <translation>Nincs forgács: a korábbi sorok nem hagytak anyagot a szerszám helyén.</translation>
    </message>
    <message>
        <source>No level is deeper</source>
        <translation>Egy szint sem mélyebb</translation>
    </message>
    <message>
        <source>None of the faces is a cylinder: the prediction is for the one that is told here.</source>
        <translation>Egyik felület sem henger: az előrejelzés az itt megadottra vonatkozik.</translation>
    </message>
    <message>
        <source>None, as aligned</source>
        <translation>Nincs, ahogy igazítva</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Most</translation>
    </message>
    <message>
        <source>Numbers of levels</source>
        <translation>Szintszámok</translation>
    </message>
    <message>
        <source>Of a level face; sets the stepover</source>
        <translation>Vízszintes felületé; ez állítja a sortávot</translation>
    </message>
    <message>
        <source>Of an operation, or of your own</source>
        <translation>Egy műveleté, vagy saját</translation>
    </message>
    <message>
        <source>Of neighbouring passes, seen from above</source>
        <translation>Szomszédos soroké, felülnézetben</translation>
    </message>
    <message>
        <source>Of the chips: mean of h_m on the way</source>
        <translation>A forgácsoké: h_m átlaga az úton</translation>
    </message>
    <message>
        <source>Of the cutting force over the time of the cuts</source>
        <translation>A forgácsolóerőé a fogások ideje alatt</translation>
    </message>
    <message>
        <source>Of the cylinder</source>
        <translation>A hengeré</translation>
    </message>
    <message>
        <source>Of the passes, seen from above, to the cylinder&apos;s axis</source>
        <translation>A soroké felülnézetben, a henger tengelyéhez képest</translation>
    </message>
    <message>
        <source>Of the path at its own feeds</source>
        <translation>A pályáé a saját előtolásaival</translation>
    </message>
    <message>
        <source>Of the tool</source>
        <translation>A szerszámé</translation>
    </message>
    <message>
        <source>Outside of what the source measured, a guess: %1.</source>
        <translation>Kívül esik azon, amit a forrás mért, becslés: %1.</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Saját</translation>
    </message>
    <message>
        <source>Passes between guides need two of them beside the faces: pick two edges, or two chains.</source>
        <translation>A vezetővonalak közötti sorokhoz a felületek mellett két vezetővonal kell: válasszon két élt vagy két láncot.</translation>
    </message>
    <message>
        <source>Passes between guides need two of them beside the faces: pick two edges, or two chains. What is picked makes %1 lines.</source>
        <translation>A vezetővonalak közötti sorokhoz a felületek mellett két vezetővonal kell: válasszon két élt vagy két láncot. A kiválasztás %1 vonalat ad.</translation>
    </message>
    <message>
        <source>Passes between guides need two of them.</source>
        <translation>A vezetővonalak közötti sorokhoz két vezetővonal kell.</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Kijelölt</translation>
    </message>
    <message>
        <source>Pick the Hole</source>
        <translation>Furat kiválasztása</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Teljesítmény</translation>
    </message>
    <message>
        <source>Power, W</source>
        <translation>Teljesítmény, W</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Becslés</translation>
    </message>
    <message>
        <source>Predicted %1: %2.</source>
        <translation>Becslés, %1: %2.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Radius of the upright arcs by which the tool comes into a pass from the air, and leaves one; smaller where the part is in the way; at first 0.1 of the tool&apos;s diameter</source>
        <translation>A függőleges ívek sugara, amelyeken a szerszám a levegőből a sorra áll, és elhagyja azt; kisebb, ahol a darab útban van; kezdetben a szerszámátmérő 0.1-szerese</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Megjegyzés</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Szórás</translation>
    </message>
    <message>
        <source>Select faces that do not stand upright; edges or sketches as guides.</source>
        <translation>Nem függőleges felületeket válasszon ki; éleket vagy vázlatokat vezetővonalnak.</translation>
    </message>
    <message>
        <source>Select the faces that are to be finished, or a finishing operation.</source>
        <translation>Válassza ki a simítandó felületeket, vagy egy simító műveletet.</translation>
    </message>
    <message>
        <source>Set Operation</source>
        <translation>Művelet beállítása</translation>
    </message>
    <message>
        <source>Sets engagement angle, step down, spindle speed and feeds as suggested</source>
        <translation>A javasolt átfogási szöget, fogásmélységet, fordulatszámot és előtolásokat állítja be</translation>
    </message>
    <message>
        <source>Shift along x</source>
        <translation>Eltolás x mentén</translation>
    </message>
    <message>
        <source>Shift along y</source>
        <translation>Eltolás y mentén</translation>
    </message>
    <message>
        <source>Shift along z</source>
        <translation>Eltolás z mentén</translation>
    </message>
    <message>
        <source>Side step, %s</source>
        <translation>Oldallépés, %s</translation>
    </message>
    <message>
        <source>Spiral inwards</source>
        <translation>Spirál befelé</translation>
    </message>
    <message>
        <source>Spiral outwards</source>
        <translation>Spirál kifelé</translation>
    </message>
    <message>
        <source>Standard deviation of h_m: the less, the evener</source>
        <translation>h_m szórása: minél kisebb, annál egyenletesebb</translation>
    </message>
    <message>
        <source>Step down, %s</source>
        <translation>Fogásmélység, %s</translation>
    </message>
    <message>
        <source>Steps on a patch are measured on the centre or on the surface, not in plan.</source>
        <translation>A felületdarab lépéseit a középen vagy a felületen mérjük, nem felülnézetben.</translation>
    </message>
    <message>
        <source>Stock on the faces</source>
        <translation>Ráhagyás a felületeken</translation>
    </message>
    <message>
        <source>Stops it</source>
        <translation>Leállítja a számítást</translation>
    </message>
    <message>
        <source>Stops the comparison; what is known stays</source>
        <translation>Leállítja az összehasonlítást; ami ismert, megmarad</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Javaslat</translation>
    </message>
    <message>
        <source>Suggest looks for the quickest cut within these limits.</source>
        <translation>A „Javaslat” a leggyorsabb fogást keresi e határokon belül.</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>Javasolt</translation>
    </message>
    <message>
        <source>Suggest…</source>
        <translation>Javaslat…</translation>
    </message>
    <message>
        <source>Surface speed from</source>
        <translation>Forgácsolási seb. ettől</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Átvétel</translation>
    </message>
    <message>
        <source>Taken into the panel.</source>
        <translation>Átkerült a panelbe.</translation>
    </message>
    <message>
        <source>Taken: Undo sets what was before.</source>
        <translation>Átvéve: a Visszavonás az előzőt állítja vissza.</translation>
    </message>
    <message>
        <source>Takes the plane face or datum plane that is selected</source>
        <translation>A kijelölt sík felületet vagy bázissíkot veszi át</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Fogak</translation>
    </message>
    <message>
        <source>Tell Rz, or choose a finishing operation, whose cusps tell the least Rz.</source>
        <translation>Adja meg az Rz értékét, vagy válasszon simító műveletet, amelynek barázdái a legkisebb Rz-t adják.</translation>
    </message>
    <message>
        <source>That make the zone narrowest</source>
        <translation>Amelyekkel a zóna a legkeskenyebb</translation>
    </message>
    <message>
        <source>The %1 is %2, of %3 points, at a radius of %4.</source>
        <translation>Alakhiba (%1): %2, %3 pontból, %4 sugárnál.</translation>
    </message>
    <message>
        <source>The %1 is %2, of %3 points.</source>
        <translation>Alakhiba (%1): %2, %3 pontból.</translation>
    </message>
    <message>
        <source>The allowance must not be negative.</source>
        <translation>A felületi ráhagyás ne legyen negatív.</translation>
    </message>
    <message>
        <source>The axial depth, the stock&apos;s allowance, must lie above 0 mm and below the tool&apos;s radius.</source>
        <translation>A tengelyirányú mélység, a ráhagyás, 0 mm felett és a szerszámsugár alatt legyen.</translation>
    </message>
    <message>
        <source>The ball does not fit into the concave surface: take a tool whose radius is smaller.</source>
        <translation>A gömb nem fér a homorú felületbe: vegyen kisebb sugarú szerszámot.</translation>
    </message>
    <message>
        <source>The chip reaches beyond the lower half of the ball: the surface is too steep for a ball-end tool along its axis.</source>
        <translation>A forgács túlér a gömb alsó felén: a felület túl meredek a tengelye mentén álló gömbvégű szerszámhoz.</translation>
    </message>
    <message>
        <source>The comparison was cancelled.</source>
        <translation>Az összehasonlítás megszakadt.</translation>
    </message>
    <message>
        <source>The corner&apos;s radius must lie between 0 and the tool&apos;s radius.</source>
        <translation>A saroksugár 0 és a szerszámsugár között legyen.</translation>
    </message>
    <message>
        <source>The cusp height must be no more than the radius of the tool&apos;s ball or corner.</source>
        <translation>A barázdamagasság ne legyen nagyobb, mint a szerszám gömbjének vagy sarkának sugara.</translation>
    </message>
    <message>
        <source>The cusp height must not be negative.</source>
        <translation>A barázdamagasság ne legyen negatív.</translation>
    </message>
    <message>
        <source>The datum is no longer there: choose another one.</source>
        <translation>A bázis már nincs meg: válasszon másikat.</translation>
    </message>
    <message>
        <source>The datum is one plane: select a plane face or a datum plane.</source>
        <translation>A bázis egyetlen sík: jelöljön ki egy sík felületet vagy bázissíkot.</translation>
    </message>
    <message>
        <source>The feed direction is 0 to 90 degrees from the cylinder&apos;s axis.</source>
        <translation>Az előtolás iránya 0 és 90 fok között van a henger tengelyéhez képest.</translation>
    </message>
    <message>
        <source>The feed direction must be a number of degrees.</source>
        <translation>Az előtolás iránya fokban megadott szám legyen.</translation>
    </message>
    <message>
        <source>The feed per tooth is too large beside the stepover: the tooth before does not bound the chip, which has no mean thickness by its face.</source>
        <translation>A fogankénti előtolás túl nagy a sortávhoz képest: az előző fog nem határolja a forgácsot, amelynek így nincs átlagos vastagsága a felülete szerint.</translation>
    </message>
    <message>
        <source>The feed per tooth must lie above 0 mm and below the tool&apos;s radius.</source>
        <translation>A fogankénti előtolás 0 mm felett és a szerszámsugár alatt legyen.</translation>
    </message>
    <message>
        <source>The file has points to measure, but no measured ones, FA(name)=FEAT/POINT,CART: open the file of results that the program writes.</source>
        <translation>A fájlban mérendő pontok vannak, de mértek nincsenek, FA(name)=FEAT/POINT,CART: nyissa meg az eredményfájlt, amelyet a program ír.</translation>
    </message>
    <message>
        <source>The floors of &apos;%1&apos; lie at several depths: make an operation for each depth, and optimise one by one.</source>
        <translation>„%1” fenekei több mélységben vannak: hozzon létre mélységenként egy műveletet, és egyenként optimalizálja őket.</translation>
    </message>
    <message>
        <source>The guides cross each other: pick two that lie side by side.</source>
        <translation>A vezetővonalak keresztezik egymást: válasszon két egymás mellettit.</translation>
    </message>
    <message>
        <source>The highest of what stands between two passes</source>
        <translation>A legmagasabb, ami két sor között megmarad</translation>
    </message>
    <message>
        <source>The job &apos;%1&apos; has no model with a shape: give it one.</source>
        <translation>A(z) „%1” munkának nincs alakkal bíró modellje: adjon hozzá egyet.</translation>
    </message>
    <message>
        <source>The largest of the tool in this material</source>
        <translation>A szerszám legnagyobb sebessége ebben az anyagban</translation>
    </message>
    <message>
        <source>The largest share of a chip that is cut at less than a fifth of the tool&apos;s diameter</source>
        <translation>A forgács legnagyobb része, amelyet a szerszámátmérő ötödénél kisebb átmérő vág</translation>
    </message>
    <message>
        <source>The largest that its edges stand</source>
        <translation>A legnagyobb, amelyet az élei elviselnek</translation>
    </message>
    <message>
        <source>The largest thickness of all chips</source>
        <translation>Az összes forgács legnagyobb vastagsága</translation>
    </message>
    <message>
        <source>The lead radius must not be negative.</source>
        <translation>A rá-/lefutási sugár ne legyen negatív.</translation>
    </message>
    <message>
        <source>The least cutting speed of the working edge</source>
        <translation>A dolgozó él legkisebb forgácsolási sebessége</translation>
    </message>
    <message>
        <source>The least of the tool in this material</source>
        <translation>A szerszám legkisebb sebessége ebben az anyagban</translation>
    </message>
    <message>
        <source>The path of the tool of %1 mm touches no material: check the region and the hole.</source>
        <translation>A(z) %1 mm-es szerszám pályája nem ér anyagot: ellenőrizze a területet és a furatot.</translation>
    </message>
    <message>
        <source>The path of this strategy cuts nothing.</source>
        <translation>Ennek a stratégiának a pályája semmit sem vág.</translation>
    </message>
    <message>
        <source>The plane in which the points were aligned</source>
        <translation>A sík, amelyben a pontokat igazították</translation>
    </message>
    <message>
        <source>The point %1 does not have six numbers after CART.</source>
        <translation>A(z) %1 pontnak nincs hat száma a CART után.</translation>
    </message>
    <message>
        <source>The point %1 does not have six numbers, a normal among them.</source>
        <translation>A(z) %1 pontnak nincs hat száma, köztük normális.</translation>
    </message>
    <message>
        <source>The point %1 is told in polar coordinates: have the program write CART.</source>
        <translation>A(z) %1 pont polárkoordinátás: írasson a programmal CART-ot.</translation>
    </message>
    <message>
        <source>The safe height must not lie below the top, nor the clearance height below it.</source>
        <translation>A biztonsági magasság ne legyen a felső sík alatt, sem az elhaladási magasság alatta.</translation>
    </message>
    <message>
        <source>The spindle speed of &apos;%s&apos; is 0: set it, for the feed per tooth.</source>
        <translation>„%s” fordulatszáma 0: állítsa be a fogankénti előtoláshoz.</translation>
    </message>
    <message>
        <source>The stepover makes too many passes: raise it.</source>
        <translation>A sortáv túl sok sort ad: növelje.</translation>
    </message>
    <message>
        <source>The stepover must be positive and no more than the tool&apos;s diameter.</source>
        <translation>A sortáv legyen pozitív, és legfeljebb a szerszámátmérő.</translation>
    </message>
    <message>
        <source>The stepover must lie above 0 mm and below the tool&apos;s diameter.</source>
        <translation>A sortáv 0 mm felett és a szerszámátmérő alatt legyen.</translation>
    </message>
    <message>
        <source>The stock on the faces is %1 mm, and the ball&apos;s radius %2 mm: more than the ball can take; rough the part first.</source>
        <translation>A felületek ráhagyása %1 mm, a gömb sugara %2 mm: több, mint amit a gömb le tud venni; előbb nagyolja a darabot.</translation>
    </message>
    <message>
        <source>The stock on the faces is %1 mm: it must be more than 0.</source>
        <translation>A felületek ráhagyása %1 mm: legyen nagyobb 0-nál.</translation>
    </message>
    <message>
        <source>The surface speeds must rise.</source>
        <translation>A forgácsolási sebességek növekedjenek.</translation>
    </message>
    <message>
        <source>The tolerance must be positive.</source>
        <translation>A tűrés legyen pozitív.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; has no ball end, and the advisor&apos;s chips are those of a ball: choose a ball end mill.</source>
        <translation>A(z) „%1” szerszám nem gömbvégű, a tanácsadó forgácsai pedig gömbé: válasszon gömbvégű marót.</translation>
    </message>
    <message>
        <source>The tool controller &apos;%1&apos; has no spindle speed, and without it there is no feed per tooth: set it.</source>
        <translation>A(z) „%1” szerszámvezérlőnek nincs fordulatszáma, e nélkül pedig nincs fogankénti előtolás: állítsa be.</translation>
    </message>
    <message>
        <source>The tool controller has no spindle speed now.</source>
        <translation>A szerszámvezérlőnek most nincs fordulatszáma.</translation>
    </message>
    <message>
        <source>The tool touches none of the picked faces: take a smaller one, or lower FinalDepth.</source>
        <translation>A szerszám egyik kiválasztott felületet sem éri: vegyen kisebbet, vagy csökkentse: [FinalDepth].</translation>
    </message>
    <message>
        <source>The tool touches the faces nowhere but at edges.</source>
        <translation>A szerszám csak éleken érinti a felületeket.</translation>
    </message>
    <message>
        <source>The tool touches the faces nowhere but at their borders.</source>
        <translation>A szerszám csak a peremükön érinti a felületeket.</translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be above 0 mm.</source>
        <translation>A szerszámátmérő 0 mm felett legyen.</translation>
    </message>
    <message>
        <source>The tool&apos;s radius must be positive.</source>
        <translation>A szerszámsugár legyen pozitív.</translation>
    </message>
    <message>
        <source>Their strategy</source>
        <translation>A stratégiájuk</translation>
    </message>
    <message>
        <source>There is no edge on %1: pick the geometry anew.</source>
        <translation>Nincs él itt: %1: válassza ki újra a geometriát.</translation>
    </message>
    <message>
        <source>Thickest</source>
        <translation>Legnagyobb vastagság</translation>
    </message>
    <message>
        <source>Times are within its limits, too</source>
        <translation>Az idők a gép határaival is</translation>
    </message>
    <message>
        <source>Tip share</source>
        <translation>Csúcs aránya</translation>
    </message>
    <message>
        <source>To try</source>
        <translation>Kipróbálandó</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Szerszám</translation>
    </message>
    <message>
        <source>Tool radius</source>
        <translation>Szerszámsugár</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Nyomaték</translation>
    </message>
    <message>
        <source>Torque, N m</source>
        <translation>Nyomaték, N m</translation>
    </message>
    <message>
        <source>Turn about x</source>
        <translation>Forgatás x körül</translation>
    </message>
    <message>
        <source>Turn about y</source>
        <translation>Forgatás y körül</translation>
    </message>
    <message>
        <source>Turn about z</source>
        <translation>Forgatás z körül</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Értékek</translation>
    </message>
    <message>
        <source>Violet to yellow</source>
        <translation>Lilától sárgáig</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Amit összehasonlítunk</translation>
    </message>
    <message>
        <source>What is taken off the face</source>
        <translation>Amit a felületről levesz</translation>
    </message>
    <message>
        <source>What measured points say</source>
        <translation>Amit a mért pontok mondanak</translation>
    </message>
    <message>
        <source>What the cut before has left, across them</source>
        <translation>Amit az előző marás rajtuk hagyott, rájuk merőlegesen</translation>
    </message>
    <message>
        <source>What to expect of a finishing</source>
        <translation>Ami egy simítástól várható</translation>
    </message>
    <message>
        <source>What tool and machine allow, beside what is set now</source>
        <translation>Amit szerszám és gép megenged, a mostani beállítás mellett</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Hol</translation>
    </message>
    <message>
        <source>Whether the tolerance of %1 is kept is not decided: measure more points.</source>
        <translation>Nem dönthető el, hogy a(z) %1 tűrést betartja-e: mérjen több pontot.</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Ablakok</translation>
    </message>
    <message>
        <source>Windows that tell times begin with it</source>
        <translation>Az időket mutató ablakok ezzel indulnak</translation>
    </message>
    <message>
        <source>Within the limits of the machine</source>
        <translation>A gép határain belül</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>berezgés</translation>
    </message>
    <message>
        <source>chip thickness</source>
        <translation>forgácsvastagság</translation>
    </message>
    <message>
        <source>depth %1, not %2 %3</source>
        <translation>mélység %1, nem %2 %3</translation>
    </message>
    <message>
        <source>face radius %1, not %2 %3</source>
        <translation>felület sugara %1, nem %2 %3</translation>
    </message>
    <message>
        <source>feed per tooth %1, not %2 %3</source>
        <translation>fogankénti előtolás %1, nem %2 %3</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nincs megadva</translation>
    </message>
    <message>
        <source>passes %1, not %2</source>
        <translation>sorok: %1, nem %2</translation>
    </message>
    <message>
        <source>profile of a surface in the datum</source>
        <translation>felület profilja a bázishoz</translation>
    </message>
    <message>
        <source>profile of the round face in the datum</source>
        <translation>a hengeres felület profilja a bázishoz</translation>
    </message>
    <message>
        <source>spindle speed %1 rev/min, not %2</source>
        <translation>fordulatszám %1 ford/perc, nem %2</translation>
    </message>
    <message>
        <source>stepover %1, not %2 %3</source>
        <translation>sortáv %1, nem %2 %3</translation>
    </message>
    <message>
        <source>the area left</source>
        <translation>a maradék terület</translation>
    </message>
    <message>
        <source>the force</source>
        <translation>az erő</translation>
    </message>
    <message>
        <source>the machine&apos;s feed</source>
        <translation>a gép előtolása</translation>
    </message>
    <message>
        <source>the power</source>
        <translation>a teljesítmény</translation>
    </message>
    <message>
        <source>the spindle speed</source>
        <translation>a fordulatszám</translation>
    </message>
    <message>
        <source>the tool&apos;s diameter</source>
        <translation>a szerszámátmérő</translation>
    </message>
    <message>
        <source>the tools&apos; chip thickness</source>
        <translation>a forgácsvastagság</translation>
    </message>
    <message>
        <source>the tools&apos; cutting length</source>
        <translation>a vágóhossz</translation>
    </message>
    <message>
        <source>the torque</source>
        <translation>a nyomaték</translation>
    </message>
    <message>
        <source>tool radius %1, not %2 %3</source>
        <translation>szerszámsugár %1, nem %2 %3</translation>
    </message>
    <message>
        <source>force</source>
        <translation>erő</translation>
    </message>
    <message>
        <source>power</source>
        <translation>teljesítmény</translation>
    </message>
    <message>
        <source>to</source>
        <translation>eddig</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>nyomaték</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Felület</translation>
    </message>
    <message>
        <source>Close the open panel first.</source>
        <translation>Először zárja be a nyitott panelt.</translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation>Ami korlátozza</translation>
    </message>
    <message>
        <source>The suggestion was cancelled.</source>
        <translation>A javaslat keresése megszakadt.</translation>
    </message>
    <message>
        <source>The datum of the inspection is no longer there: it goes on without one.</source>
        <translation>A vizsgálat bázisa már nincs meg: bázis nélkül folytatódik.</translation>
    </message>
    <message>
        <source>The operation is no longer there: choose another one.</source>
        <translation>A művelet már nincs meg: válasszon másikat.</translation>
    </message>
    <message>
        <source>Compare %s with</source>
        <translation>%s összehasonlítása ezzel</translation>
    </message>
    <message>
        <source>EvenLoad Compare</source>
        <translation>EvenLoad összehasonlítás</translation>
    </message>
    <message>
        <source>EvenLoad Report</source>
        <translation>EvenLoad jelentés</translation>
    </message>
    <message>
        <source>Simulating the operations of %s</source>
        <translation>%s műveleteinek szimulálása</translation>
    </message>
    <message>
        <source>There is no browser for the report: %s</source>
        <translation>Nincs böngésző a jelentéshez: %s</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cuts nothing: there is nothing to simulate.</source>
        <translation>„%1“ nem vág semmit: nincs mit szimulálni.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has a ball end mill, whose loads are not simulated: EvenLoad Show Surface, or evenload.surface_simulation, tells what it leaves on the faces.</source>
        <translation>„%1“ szerszáma gömbvégű maró, amelynek terhelését a szimuláció nem ismeri: az EvenLoad felület mutatása vagy az evenload.surface_simulation megmondja, mit hagy a felületeken.</translation>
    </message>
    <message>
        <source>95 % of cusps below</source>
        <translation>A barázdák 95 %-a kisebb</translation>
    </message>
    <message>
        <source>A click near an open side in the 3D view: over that side the tool comes in first</source>
        <translation>Kattintás egy nyitott oldal közelébe a 3D nézetben: a szerszám először azon az oldalon át érkezik</translation>
    </message>
    <message>
        <source>Cells of %1 mm are coarse beside a stepover of %2 mm: cusps may be missed.</source>
        <translation>A %1 mm-es cellák durvák a %2 mm-es sortávhoz képest: barázdák maradhatnak észrevétlenül.</translation>
    </message>
    <message>
        <source>Chips are told along an EvenLoad Finishing only.</source>
        <translation>Forgácsokat csak EvenLoad simítás mentén lehet megadni.</translation>
    </message>
    <message>
        <source>Colours the faces by what the path leaves on them, or ends that</source>
        <translation>A felületeket aszerint színezi, amit a pálya rajtuk hagy, vagy befejezi ezt</translation>
    </message>
    <message>
        <source>Cusps, mean</source>
        <translation>Barázdák átlaga</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Kontúrsértés</translation>
    </message>
    <message>
        <source>Height over the part</source>
        <translation>Magasság a darab felett</translation>
    </message>
    <message>
        <source>Largest gouge</source>
        <translation>Legnagyobb kontúrsértés</translation>
    </message>
    <message>
        <source>Largest shown</source>
        <translation>Legnagyobb mutatott érték</translation>
    </message>
    <message>
        <source>Mean chip thickness h_m</source>
        <translation>Közepes forgácsvastagság</translation>
    </message>
    <message>
        <source>None of the picked faces lies on top: others of the models hide them.</source>
        <translation>A kijelölt felületek egyike sincs felül: a modellek más felületei eltakarják őket.</translation>
    </message>
    <message>
        <source>Not cut</source>
        <translation>Nincs megmunkálva</translation>
    </message>
    <message>
        <source>Open side at</source>
        <translation>Nyitott oldal itt</translation>
    </message>
    <message>
        <source>Pick the Open Side</source>
        <translation>Nyitott oldal kiválasztása</translation>
    </message>
    <message>
        <source>Share of the tip</source>
        <translation>A csúcs aránya</translation>
    </message>
    <message>
        <source>Stops the simulation; what is known stays</source>
        <translation>Leállítja a szimulációt; ami ismert, megmarad</translation>
    </message>
    <message>
        <source>Surface of %s</source>
        <translation>%s felülete</translation>
    </message>
    <message>
        <source>The models have no surface that looks up: nothing can be simulated.</source>
        <translation>A modelleknek nincs felfelé néző felülete: nincs mit szimulálni.</translation>
    </message>
    <message>
        <source>The path of &apos;%1&apos; lies beside the models.</source>
        <translation>„%1“ pályája a modellek mellett fut.</translation>
    </message>
    <message>
        <source>The resolution is %1 mm: it must be at least %2 mm.</source>
        <translation>A felbontás %1 mm: legalább %2 mm legyen.</translation>
    </message>
    <message>
        <source>The resolution of %1 mm makes too many cells: choose at least %2 mm.</source>
        <translation>A %1 mm-es felbontás túl sok cellát ad: válasszon legalább %2 mm-t.</translation>
    </message>
    <message>
        <source>The tolerance is %1 mm: it must be at least %2 mm.</source>
        <translation>A tűrés %1 mm: legalább %2 mm legyen.</translation>
    </message>
    <message>
        <source>The tool first comes in over the open side that is nearest to this place</source>
        <translation>A szerszám először azon a nyitott oldalon át érkezik, amelyik ehhez a helyhez a legközelebb van</translation>
    </message>
    <message>
        <source>The triangles leave the part by up to %1 mm, and cusps are told no better than that: a finer tolerance takes longer.</source>
        <translation>A háromszögek legfeljebb %1 mm-rel térnek el a darabtól, és a barázdák ennél nem pontosabbak: a finomabb tűrés tovább tart.</translation>
    </message>
    <message>
        <source>Within 10 % of the wish</source>
        <translation>10 %-on belül a kívánttal</translation>
    </message>
    <message>
        <source>Writes what the faces are coloured by</source>
        <translation>Kiírja, ami szerint a felületek színezettek</translation>
    </message>
    <message>
        <source>not cut</source>
        <translation>nincs megmunkálva</translation>
    </message>
    <message>
        <source>The cusp height makes too many passes: raise it.</source>
        <translation>A barázdamagasság túl sok sort ad: növelje meg.</translation>
    </message>
    <message>
        <source>What is the same between all passes: their distance seen from above, or the height of what stands between them</source>
        <translation>Ami minden sor között azonos: felülnézeti távolságuk, vagy a köztük maradó barázda magassága</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Túlnyúlás</translation>
    </message>
    <message>
        <source>How far passes go on beyond the border of the faces, seen from above: along what goes on there or falls away, not up what rises</source>
        <translation>Mennyivel mennek tovább a sorok a felületek szélén túl, felülnézetben: ami ott folytatódik vagy lejt, annak mentén, ami emelkedik, arra nem fel</translation>
    </message>
    <message>
        <source>One way between guides</source>
        <translation>Egy irány vezetővonalak között</translation>
    </message>
    <message>
        <source>Parallel passes to and fro, or all in one direction with a way back over the part; passes along the outline of the faces, or a spiral round their middle, from the outside or from the inside on; or passes between two picked edges, from the shape of one to the other&apos;s, to and fro or all in one direction</source>
        <translation>Párhuzamos sorok oda-vissza, vagy mind egy irányban visszaúttal a darab felett; sorok a felületek körvonala mentén, vagy spirál a közepük körül, kívülről vagy belülről kezdve; vagy sorok két kiválasztott él között, az egyik alakjából a másikéba, oda-vissza vagy mind egy irányban</translation>
    </message>
    <message>
        <source>The extension must not be negative.</source>
        <translation>A túlnyúlás nem lehet negatív.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2, %1</translation>
    </message>
    <message>
        <source>%d, of %s</source>
        <translation>%d, forrás: %s</translation>
    </message>
    <message>
        <source>%s to %s %s</source>
        <translation>%s … %s %s</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Korlát</translation>
    </message>
    <message>
        <source>By the regressions of ten milled parts, for a %s face, passes at %g° to its axis, Rz %s.</source>
        <translation>Tíz mart darab regressziói szerint, %s felületre, tengelyéhez %g°-ban futó sorokkal, Rz %s.</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Bizonyítás</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Parancs</translation>
    </message>
    <message>
        <source>Contact, point</source>
        <translation>Érintkezés, pont</translation>
    </message>
    <message>
        <source>Datum plane</source>
        <translation>Bázissík</translation>
    </message>
    <message>
        <source>Deviation, %s</source>
        <translation>Eltérés, %s</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Eltérések</translation>
    </message>
    <message>
        <source>Engagement along %s</source>
        <translation>Átfogás, %s</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Felületek</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Készülék</translation>
    </message>
    <message>
        <source>Incident</source>
        <translation>Esemény</translation>
    </message>
    <message>
        <source>Incidents: %d, see below.</source>
        <translation>Események: %d, lásd alább.</translation>
    </message>
    <message>
        <source>Inspection of %s</source>
        <translation>Vizsgálat: %s</translation>
    </message>
    <message>
        <source>Load of %s over time</source>
        <translation>%s terhelése az idő függvényében</translation>
    </message>
    <message>
        <source>Map of the deviations</source>
        <translation>Az eltérések térképe</translation>
    </message>
    <message>
        <source>Material of the forces</source>
        <translation>Az erők anyaga</translation>
    </message>
    <message>
        <source>Measured, %s</source>
        <translation>Mért, %s</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>Multiplikátor</translation>
    </message>
    <message>
        <source>No gouge, no rapid or plunge in material.</source>
        <translation>Nincs kontúrsértés, sem gyorsjárat vagy függőleges merülés anyagban.</translation>
    </message>
    <message>
        <source>No incidents.</source>
        <translation>Nincs esemény.</translation>
    </message>
    <message>
        <source>No incidents; what must stay is not known for %s.</source>
        <translation>Nincs esemény; nem ismert, minek kell megmaradnia itt: %s.</translation>
    </message>
    <message>
        <source>Not in the times</source>
        <translation>Az időkben nincs benne</translation>
    </message>
    <message>
        <source>Not listed: %d more.</source>
        <translation>Nincs felsorolva: még %d.</translation>
    </message>
    <message>
        <source>Not simulated: %s.</source>
        <translation>Nincs szimulálva: %s.</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Műveletek</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Hely</translation>
    </message>
    <message>
        <source>Plunge in material</source>
        <translation>Függőleges merülés anyagba</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Pont</translation>
    </message>
    <message>
        <source>Predicted, %s</source>
        <translation>Becslés, %s</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Becslés</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Sugár</translation>
    </message>
    <message>
        <source>Rapid in material</source>
        <translation>Gyorsjárat anyagban</translation>
    </message>
    <message>
        <source>Rest and incidents of %s</source>
        <translation>Maradék és események, %s</translation>
    </message>
    <message>
        <source>R² adjusted</source>
        <translation>Korrigált R²</translation>
    </message>
    <message>
        <source>Shift of the points</source>
        <translation>A pontok eltolása</translation>
    </message>
    <message>
        <source>Simulation of %s</source>
        <translation>%s szimulációja</translation>
    </message>
    <message>
        <source>The job has no active operation.</source>
        <translation>A feladatnak nincs aktív művelete.</translation>
    </message>
    <message>
        <source>The minimum zone is not proved; what is left of the forces&apos; balance is %.1e.</source>
        <translation>A minimális zóna nem bizonyított; az erők egyensúlyának maradéka %.1e.</translation>
    </message>
    <message>
        <source>The minimum zone is proved; what is left of the forces&apos; balance is %.1e.</source>
        <translation>A minimális zóna bizonyított; az erők egyensúlyának maradéka %.1e.</translation>
    </message>
    <message>
        <source>Time at the programmed feeds</source>
        <translation>Idő a programozott előtolásokkal</translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation>Idő a gépen</translation>
    </message>
    <message>
        <source>Tool changes, dwells of the spindle, coolant</source>
        <translation>Szerszámcserék, az orsó várakozásai, hűtés</translation>
    </message>
    <message>
        <source>Turn of the points</source>
        <translation>A pontok elforgatása</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>homorú</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>domború</translation>
    </message>
    <message>
        <source>en</source>
        <translation>hu</translation>
    </message>
    <message>
        <source>inner</source>
        <translation>belső</translation>
    </message>
    <message>
        <source>none, as aligned</source>
        <translation>egyik sem, a beállítás szerint</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>külső</translation>
    </message>
    <message>
        <source>through %s %s, normal %s</source>
        <translation>e ponton át: %s %s, normális: %s</translation>
    </message>
    <message>
        <source>%.0f s on the machine</source>
        <translation>%.0f s a gépen</translation>
    </message>
    <message>
        <source>%1 points on %2</source>
        <translation>%1 pont, %2</translation>
    </message>
    <message>
        <source>, %.2f of the ideal</source>
        <translation>, az ideális %.2f-szerese</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Terhelés</translation>
    </message>
    <message>
        <source>Rest and incidents</source>
        <translation>Maradék és események</translation>
    </message>
    <message>
        <source>beyond the tolerance</source>
        <translation>tűrésen kívül</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>érintkezés</translation>
    </message>
    <message>
        <source>deviation, %s; above 0: %s</source>
        <translation>eltérés, %s; 0 felett: %s</translation>
    </message>
    <message>
        <source>engagement angle, degrees</source>
        <translation>átfogási szög, fok</translation>
    </message>
    <message>
        <source>engagement, degrees</source>
        <translation>átfogás, fok</translation>
    </message>
    <message>
        <source>force in XY, N</source>
        <translation>erő XY-ban, N</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>kontúrsértés</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>furat</translation>
    </message>
    <message>
        <source>in a fixture</source>
        <translation>készülékben</translation>
    </message>
    <message>
        <source>largest engagement %.1f°</source>
        <translation>legnagyobb átfogás %.1f°</translation>
    </message>
    <message>
        <source>largest force %.0f N</source>
        <translation>legnagyobb erő %.0f N</translation>
    </message>
    <message>
        <source>mean of a revolution</source>
        <translation>egy fordulat átlaga</translation>
    </message>
    <message>
        <source>no material, no forces</source>
        <translation>nincs anyag, nincsenek erők</translation>
    </message>
    <message>
        <source>no rest, no incidents</source>
        <translation>nincs maradék, nincs esemény</translation>
    </message>
    <message>
        <source>outside of the feature</source>
        <translation>az elemen kívül</translation>
    </message>
    <message>
        <source>part</source>
        <translation>darab</translation>
    </message>
    <message>
        <source>part, top at z = %g</source>
        <translation>darab, teteje: z = %g</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>csúcs</translation>
    </message>
    <message>
        <source>plunge in material</source>
        <translation>függőleges merülés anyagba</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>zseb</translation>
    </message>
    <message>
        <source>rapid in material</source>
        <translation>gyorsjárat anyagban</translation>
    </message>
    <message>
        <source>reference %.4g N</source>
        <translation>referencia %.4g N</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>maradék</translation>
    </message>
    <message>
        <source>start</source>
        <translation>kezdet</translation>
    </message>
    <message>
        <source>target %.4g°</source>
        <translation>cél %.4g°</translation>
    </message>
    <message>
        <source>too much material</source>
        <translation>túl sok anyag</translation>
    </message>
    <message>
        <source>%s: %d s, %d passes</source>
        <translation>%s: %d s, %d sor</translation>
    </message>
    <message>
        <source>Choose the open side</source>
        <translation>Nyitott oldal választása</translation>
    </message>
    <message>
        <source>How the tool reaches its depth; Automatic: an open side, else a set hole, else a helix, else a ramp</source>
        <translation>Hogyan éri el a szerszám a mélységét; Automatikus: nyitott oldal, különben megadott furat, különben csigavonal, különben rámpa</translation>
    </message>
    <message>
        <source>No side of %1 is open, over which the tool could come in: turn ChooseOpenSide off.</source>
        <translation>%1 egyik oldala sem nyitott, hogy azon át érkezhetne a szerszám: kapcsolja ki: [ChooseOpenSide].</translation>
    </message>
    <message>
        <source>Whether the open side over which the tool first comes in is chosen by a place</source>
        <translation>Egy hely válassza-e ki azt a nyitott oldalt, amelyen át a szerszám először érkezik</translation>
    </message>
    <message>
        <source>A Lamé spiral around an island begins beside its wall: drill the hole there, or choose the entry &apos;Automatic&apos;.</source>
        <translation>A sziget körüli Lamé-spirál annak fala mellett kezdődik: ott fúrja a furatot, vagy válassza az „Automatikus” bemerülést.</translation>
    </message>
    <message>
        <source>A Lamé spiral around an island in open stock comes from outside, not from a hole: choose the entry &apos;Automatic&apos;.</source>
        <translation>Nyitott nyersdarabban a sziget körüli Lamé-spirál kívülről jön, nem furatból: válassza az „Automatikus” bemerülést.</translation>
    </message>
    <message>
        <source>A Lamé spiral clears pockets without islands, or with one island and an outline that is all wall or all open: take the operation Adaptive.</source>
        <translation>A Lamé-spirál sziget nélküli zsebet mar ki, vagy olyat, amelyben egy sziget van, és körvonala végig fal vagy végig nyitott: használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>A Lamé spiral would clear only %1 % of this pocket: take the operation Adaptive.</source>
        <translation>A Lamé-spirál e zsebnek csak %1 %-át marná ki: használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>An island</source>
        <translation>Egy sziget</translation>
    </message>
    <message>
        <source>Between the walls there is too little room for a Lamé spiral: take the operation Adaptive.</source>
        <translation>A falak között túl kevés a hely egy Lamé-spirálnak: használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>Centre lies outside the pocket: move it inside, or leave it unset.</source>
        <translation>[Centre]: a zseben kívül van: helyezze belülre, vagy ne adja meg.</translation>
    </message>
    <message>
        <source>No Lamé curve resembles this pocket: take the operation Adaptive.</source>
        <translation>Egyetlen Lamé-görbe sem hasonlít erre a zsebre: használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>No Lamé spiral keeps to the engagement angle in this pocket: take the operation Adaptive.</source>
        <translation>Ebben a zsebben egyetlen Lamé-spirál sem tartja be az átfogási szöget: használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>No Lamé spiral leads from one outline of this pocket to the other: take the operation Adaptive.</source>
        <translation>Egyetlen Lamé-spirál sem vezet e zseb egyik körvonalától a másikig: használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>No Lamé spiral leads from the pre-drilled hole to the pocket&apos;s walls: move EntryPoint towards the middle, or choose the entry &apos;Helix&apos;.</source>
        <translation>Egyetlen Lamé-spirál sem vezet az előfúrt furattól a zseb falaihoz: helyezze közelebb a közepéhez: [EntryPoint], vagy válassza a „Csigavonal” bemerülést.</translation>
    </message>
    <message>
        <source>Only curves of four segments have two courses: set SemiAxisACourse and SemiAxisBCourse to the same values, or leave one of them empty.</source>
        <translation>Csak négy szegmensű görbének van két lefutása: adjon meg azonos értékeket: [SemiAxisACourse] és [SemiAxisBCourse], vagy hagyja az egyiket üresen.</translation>
    </message>
    <message>
        <source>SemiAxisA and SemiAxisB leave no room for a spiral around its entry: set larger ones, or leave them unset.</source>
        <translation>[SemiAxisA] és [SemiAxisB] nem hagy helyet a bemerülés körüli spirálnak: adjon meg nagyobbakat, vagy ne adja meg őket.</translation>
    </message>
    <message>
        <source>The pre-drilled hole is too tight to start a spiral from: drill it wider, move EntryPoint towards the middle, or choose the entry &apos;Helix&apos;.</source>
        <translation>Az előfúrt furat túl szűk egy spirál kezdéséhez: fúrja nagyobbra, helyezze közelebb a zseb közepéhez: [EntryPoint], vagy válassza a „Csigavonal” bemerülést.</translation>
    </message>
    <message>
        <source>The pre-drilled hole lies outside this pocket: choose the entry &apos;Automatic&apos;, or another hole.</source>
        <translation>Az előfúrt furat e zseben kívül van: válassza az „Automatikus” bemerülést, vagy másik furatot.</translation>
    </message>
    <message>
        <source>The tool of %1 mm does not fit into the pocket: %2</source>
        <translation>A(z) %1 mm-es szerszám nem fér a zsebbe: %2</translation>
    </message>
    <message>
        <source>With the set Segments, ExponentEnd or Rotation the largest spiral would clear %1 % of this pocket: leave them unset, or take the operation Adaptive.</source>
        <translation>A megadottakkal ([Segments], [ExponentEnd] vagy [Rotation]) a legnagyobb spirál e zseb %1 %-át marná ki: ne adja meg őket, vagy használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>With the set properties no Lamé curve keeps clear of the walls: leave some of them unset, or take the operation Adaptive.</source>
        <translation>A megadott tulajdonságokkal egyetlen Lamé-görbe sem kerüli el a falakat: némelyiket ne adja meg, vagy használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>With these courses no Lamé spiral keeps to the engagement angle: make SemiAxisACourse, SemiAxisBCourse and ExponentCourse more even, or leave them empty.</source>
        <translation>Ezekkel a lefutásokkal egyetlen Lamé-spirál sem tartja be az átfogási szöget: tegye egyenletesebbé: [SemiAxisACourse], [SemiAxisBCourse] és [ExponentCourse], vagy hagyja üresen őket.</translation>
    </message>
    <message>
        <source>With these courses no Lamé spiral leads from its first turn to its last: leave SemiAxisACourse, SemiAxisBCourse and ExponentCourse empty, or take the operation Adaptive.</source>
        <translation>Ezekkel a lefutásokkal egyetlen Lamé-spirál sem vezet az első menetétől az utolsóig: hagyja üresen: [SemiAxisACourse], [SemiAxisBCourse] és [ExponentCourse], vagy használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>With this Centre the largest spiral would clear %1 % of this pocket: move Centre towards the middle, leave it unset, or take the operation Adaptive.</source>
        <translation>Ezzel az értékkel ([Centre]) a legnagyobb spirál e zseb %1 %-át marná ki: helyezze közelebb a zseb közepéhez: [Centre], ne adja meg, vagy használja az adaptív műveletet.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cuts the faces nowhere.</source>
        <translation>„%1“ sehol sem vágja a felületeket.</translation>
    </message>
    <message>
        <source>Places of the patch are %1 mm apart, coarse beside marks of %2 mm, which may be lost: a smaller patch would tell them.</source>
        <translation>A folt pontjai %1 mm-re vannak egymástól, ami durva a %2 mm-es nyomok mellett, ezek elveszhetnek: egy kisebb folt megmutatná őket.</translation>
    </message>
    <message>
        <source>R_z across the feed</source>
        <translation>R_z az előtolásra merőlegesen</translation>
    </message>
    <message>
        <source>R_z along the feed</source>
        <translation>R_z az előtolás mentén</translation>
    </message>
    <message>
        <source>What &apos;%1&apos; cuts is narrower than a patch of %2 mm, whose roughness is told: pick wider faces.</source>
        <translation>Amit „%1“ vág, keskenyebb egy %2 mm-es foltnál, amelynek érdességét megadjuk: szélesebb felületeket kell választani.</translation>
    </message>
    <message>
        <source>FeedControl is &apos;%1&apos;, but the tool &apos;%2&apos; has no ball end, and the chips that are known are those of a ball: take a ball end mill, or another FeedControl.</source>
        <translation>[FeedControl]: &apos;%1&apos;, de a(z) &apos;%2&apos; szerszám vége nem gömb, és csak a gömb forgácsai ismertek: válasszon gömbvégű marót vagy más értéket ehhez: [FeedControl].</translation>
    </message>
    <message>
        <source>FeedControl is &apos;%1&apos;, but without a spindle speed there is no feed per tooth: set that of the tool controller.</source>
        <translation>[FeedControl]: &apos;%1&apos;, de fordulatszám nélkül nincs fogankénti előtolás: adja meg a szerszámvezérlőét.</translation>
    </message>
    <message>
        <source>Feeds of the cuts: %1 to %2 mm/min, for chips with a mean thickness of %3 µm.</source>
        <translation>A forgácsolás előtolásai: %1 – %2 mm/min, %3 µm átlagos vastagságú forgácsokhoz.</translation>
    </message>
    <message>
        <source>StockOnFaces is %1 mm: it must lie between 0 and the ball&apos;s radius of %2 mm.</source>
        <translation>[StockOnFaces]: %1 mm; 0 és a gömb %2 mm-es sugara közé kell esnie.</translation>
    </message>
    <message>
        <source>What stays the same along the cuts: the feed, or the mean thickness of a ball&apos;s chips</source>
        <translation>Mi marad állandó a forgácsolás során: az előtolás vagy a gömbvégű maró forgácsának átlagos vastagsága</translation>
    </message>
    <message>
        <source>What the cut before has left above the surface that is made, across it: the feed control&apos;s chips are of that; at first 0.03 of the tool&apos;s diameter</source>
        <translation>Amit az előző megmunkálás a készülő felület fölött hagyott, arra merőlegesen: az előtolás-szabályozás forgácsai ebből vannak; kezdetben a szerszámátmérő 0,03-szorosa</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no faces that the tool could keep off: take it out of Fixtures.</source>
        <translation>A(z) &apos;%1&apos; objektumnak nincs felülete, amelyet a szerszám elkerülhetne: vegye ki innen: [Fixtures].</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a model of the job, which the tool keeps off anyway: take it out of Fixtures.</source>
        <translation>A(z) &apos;%1&apos; a munka modellje, amelyet a szerszám amúgy is elkerül: vegye ki innen: [Fixtures].</translation>
    </message>
    <message>
        <source>Clamps, vices and other objects that the tool keeps off, as from above: what lies below them is not cut. The button takes what is selected</source>
        <translation>Szorítók, satuk és más objektumok, amelyeket a szerszám felülről elkerül: ami alattuk van, azt nem forgácsolja. A gomb a kijelölt objektumokat veszi át</translation>
    </message>
    <message>
        <source>Fixture clearance</source>
        <translation>Befogók távolsága</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Befogóeszközök</translation>
    </message>
    <message>
        <source>How far the tool stays off the fixtures, all around</source>
        <translation>Milyen távol marad a szerszám a befogóeszközöktől, körös-körül</translation>
    </message>
    <message>
        <source>SafeHeight (%1 mm) lies below the top of the fixtures and their clearance (%2 mm): raise it.</source>
        <translation>[SafeHeight] (%1 mm) a befogóeszközök és távolságuk teteje (%2 mm) alatt van: emelje meg.</translation>
    </message>
    <message>
        <source>The clearance of fixtures must not be negative.</source>
        <translation>A befogóeszközök távolsága nem lehet negatív.</translation>
    </message>
    <message>
        <source>The fixtures leave the tool none of the picked faces: move them, or lower FixtureClearance.</source>
        <translation>A befogóeszközök a kijelölt felületek közül egyet sem hagynak a szerszámnak: helyezze át őket, vagy csökkentse: [FixtureClearance].</translation>
    </message>
    <message>
        <source>EvenLoad Lame Spiral</source>
        <translation>EvenLoad Lamé-spirál</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one, the surface&apos;s triangles included; into the part usually a third of it, at the most half</source>
        <translation>A pálya legnagyobb eltérése a pontostól, a felület háromszögeivel együtt; a darabba általában ennek harmada, legfeljebb a fele</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not tell its number of teeth: 1 tooth is assumed.</source>
        <translation>A(z) „%1” szerszám nem adja meg a fogszámát: 1 fogat veszünk.</translation>
    </message>
    <message>
        <source>%.0f rev/min, %.3g %s</source>
        <translation>%.0f ford/perc, %.3g %s</translation>
    </message>
    <message>
        <source>Amount, %s</source>
        <translation>Mérték, %s</translation>
    </message>
    <message>
        <source>Engagement, %s</source>
        <translation>Átfogás, %s</translation>
    </message>
    <message>
        <source>Gouge, %s</source>
        <translation>Kontúrsértés, %s</translation>
    </message>
    <message>
        <source>Peak force, %s</source>
        <translation>Csúcserő, %s</translation>
    </message>
    <message>
        <source>Removal rate, %s</source>
        <translation>Anyagleválasztás, %s</translation>
    </message>
    <message>
        <source>Removes %.3g %s, now %.3g; location error %s, force %.0f N.</source>
        <translation>Leválaszt: %.3g %s, most %.3g; helyzethiba %s, erő %.0f N.</translation>
    </message>
    <message>
        <source>Rest, %s</source>
        <translation>Maradék, %s</translation>
    </message>
    <message>
        <source>axial depth, %s</source>
        <translation>fogásmélység, %s</translation>
    </message>
    <message>
        <source>gouge %s</source>
        <translation>kontúrsértés %s</translation>
    </message>
    <message>
        <source>nominal %s</source>
        <translation>névleges %s</translation>
    </message>
    <message>
        <source>plunges in material %s</source>
        <translation>függőleges merülés anyagba %s</translation>
    </message>
    <message>
        <source>rapids in material %s</source>
        <translation>gyorsjárat anyagban %s</translation>
    </message>
    <message>
        <source>removal rate, %s</source>
        <translation>anyagleválasztás, %s</translation>
    </message>
    <message>
        <source>rest %s</source>
        <translation>maradék %s</translation>
    </message>
    <message>
        <source>height of the tool&apos;s tip above z = %.3f, %s</source>
        <translation>a szerszámcsúcs magassága z = %.3f felett, %s</translation>
    </message>
    <message>
        <source>EngagementAngle and SideStep both have an expression, though each sets the other: take one of the two away.</source>
        <translation>[EngagementAngle] és [SideStep] is kifejezéssel van megadva, noha mindkettő meghatározza a másikat: törölje az egyiket.</translation>
    </message>
    <message>
        <source>cut along a wall</source>
        <translation>fogás fal mentén</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not active: activate it first.</source>
        <translation>„%1” nem aktív: előbb aktiválja.</translation>
    </message>
    <message>
        <source>SideStep is %1 mm, less than the Tolerance of %2 mm: lower Tolerance or raise EngagementAngle.</source>
        <translation>[SideStep] értéke %1 mm, kisebb, mint [Tolerance] %2 mm-es értéke: csökkentse ezt: [Tolerance], vagy növelje ezt: [EngagementAngle].</translation>
    </message>
    <message>
        <source>The preview is shown; Apply or Cancel brings the load back.</source>
        <translation>Az előnézet látszik; az Alkalmaz vagy a Mégse visszahozza a terhelést.</translation>
    </message>
    <message>
        <source>Cancelled: what is shown was simulated before.</source>
        <translation>Megszakítva: ami látható, azt korábban szimulálta.</translation>
    </message>
    <message>
        <source>Set by the expression of &apos;%s&apos;</source>
        <translation>„%s” kifejezése adja meg</translation>
    </message>
    <message>
        <source>Stops the simulation; colours come with the next path</source>
        <translation>Leállítja a szimulációt; színek a következő pályával jönnek</translation>
    </message>
    <message>
        <source>The report was cancelled.</source>
        <translation>A jelentés megszakadt.</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Adaptive</name>
    <message>
        <source>Clears pockets at constant engagement of the tool</source>
        <translation>Zsebeket mar ki állandó szerszámátfogással</translation>
    </message>
    <message>
        <source>EvenLoad Adaptive</source>
        <translation>EvenLoad adaptív</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Compare</name>
    <message>
        <source>EvenLoad Compare</source>
        <translation>EvenLoad összehasonlítás</translation>
    </message>
    <message>
        <source>Shows the load of two selected operations over time on one scale; of one, asks which other one to set beside it</source>
        <translation>Két kijelölt művelet terhelését mutatja az időben, azonos léptékben; ha csak egy van kijelölve, megkérdezi, melyik legyen mellette</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Finishing</name>
    <message>
        <source>EvenLoad Finishing</source>
        <translation>EvenLoad simítás</translation>
    </message>
    <message>
        <source>Finishes faces by passes of a ball end, bull-nosed or flat tool</source>
        <translation>Felületeket simít gömbvégű, sarokrádiuszos vagy sík végű maró soraival</translation>
    </message>
</context>
<context>
    <name>EvenLoad_FinishingAdvisor</name>
    <message>
        <source>Compares ten strategies for the selected faces or finishing operation by time, chips, cusps, tip and force, and makes an operation of one</source>
        <translation>Tíz stratégiát hasonlít össze a kijelölt felületekre vagy simító műveletre idő, forgács, barázda, csúcs és erő szerint, és műveletet készít az egyikből</translation>
    </message>
    <message>
        <source>EvenLoad Finishing Advisor</source>
        <translation>EvenLoad simítási tanácsadó</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Inspect</name>
    <message>
        <source>EvenLoad Inspect</source>
        <translation>EvenLoad vizsgálat</translation>
    </message>
    <message>
        <source>Tells where to measure the selected faces, and how far measured points lie from them</source>
        <translation>Megmutatja, hol mérendők a kijelölt felületek, és a mért pontok mennyire térnek el tőlük</translation>
    </message>
</context>
<context>
    <name>EvenLoad_LameSpiral</name>
    <message>
        <source>Clears round, square and many-sided pockets, and round islands of such shapes, by spirals</source>
        <translation>Kerek, négyzetes és sokszögű zsebeket, és ilyen alakú szigetek körül is, spirálokkal mar ki</translation>
    </message>
    <message>
        <source>EvenLoad Lamé Spiral</source>
        <translation>EvenLoad Lamé-spirál</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Optimise</name>
    <message>
        <source>EvenLoad Optimise</source>
        <translation>EvenLoad optimalizálás</translation>
    </message>
    <message>
        <source>Suggests engagement angle, step down, spindle speed and feeds within what tool and machine stand, beside what is set now</source>
        <translation>Átfogási szöget, fogásmélységet, fordulatszámot és előtolásokat javasol a szerszám és a gép határain belül, a mostani beállítás mellett</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Report</name>
    <message>
        <source>EvenLoad Report</source>
        <translation>EvenLoad jelentés</translation>
    </message>
    <message>
        <source>Simulates the operations of the job, writes a report to print and opens it in the browser</source>
        <translation>Szimulálja a feladat műveleteit, nyomtatható jelentést ír, és megnyitja a böngészőben</translation>
    </message>
</context>
<context>
    <name>EvenLoad_ShowLoad</name>
    <message>
        <source>Colours the path of the selected operation by engagement, removal rate, feed, chip thickness or force, or takes the colours away again</source>
        <translation>A kijelölt művelet pályáját átfogás, anyagleválasztás, előtolás, forgácsvastagság vagy erő szerint színezi, vagy leveszi a színeket</translation>
    </message>
    <message>
        <source>EvenLoad Show Load</source>
        <translation>EvenLoad terhelés mutatása</translation>
    </message>
</context>
<context>
    <name>EvenLoad_ShowSurface</name>
    <message>
        <source>Colours the faces below the selected operation by cusps, gouges, what is left, chip thickness or the tip&apos;s share, or takes the colours away again</source>
        <translation>A kijelölt művelet alatti felületeket a barázdák, a kontúrsértések, a megmaradt anyag, a forgácsvastagság vagy a csúcs aránya szerint színezi, vagy leveszi a színeket</translation>
    </message>
    <message>
        <source>EvenLoad Show Surface</source>
        <translation>EvenLoad felület mutatása</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Simulation</name>
    <message>
        <source>EvenLoad Simulation</source>
        <translation>EvenLoad szimuláció</translation>
    </message>
    <message>
        <source>Shows engagement, removal rate and force of the selected operation over time, beside another one if wished, with a cursor in the 3D view</source>
        <translation>A kijelölt művelet átfogását, anyagleválasztását és erejét mutatja az időben, kívánságra egy másik mellett, jelölővel a 3D nézetben</translation>
    </message>
</context>
<context>
    <name>EvenLoad_StabilityChart</name>
    <message>
        <source>EvenLoad Stability Chart</source>
        <translation>EvenLoad stabilitási térkép</translation>
    </message>
    <message>
        <source>Shows at which spindle speeds and depths an operation chatters, and finds the best cut</source>
        <translation>Megmutatja, milyen fordulatszámoknál és mélységeknél rezeg be a művelet, és megkeresi a legjobb fogást</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Trochoid</name>
    <message>
        <source>Cuts slots by trochoids at constant engagement of the tool</source>
        <translation>Hornyokat mar trochoidokkal, állandó szerszámátfogással</translation>
    </message>
    <message>
        <source>EvenLoad Trochoid</source>
        <translation>EvenLoad trochoid</translation>
    </message>
</context>
</TS>
