<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A last pass along the walls takes what is left</source>
        <translation>Ein letzter Durchgang entlang der Wände nimmt, was übrig ist</translation>
    </message>
    <message>
        <source>Arcs in the output (G2, G3); without, lines only</source>
        <translation>Bögen in der Ausgabe (G2, G3); sonst nur Geraden</translation>
    </message>
    <message>
        <source>Area over side step and feed, in s: the time if all were cut at the angle and the feed</source>
        <translation>Fläche durch Seitenzustellung und Vorschub, in s: die Zeit, wenn alles mit dem Winkel und dem Vorschub geschnitten würde</translation>
    </message>
    <message>
        <source>Area that the tool could reach and did not clear</source>
        <translation>Fläche, die das Werkzeug erreichen konnte und nicht ausgeräumt hat</translation>
    </message>
    <message>
        <source>Cap of the feed control; at first twice the tool controller&apos;s horizontal feed</source>
        <translation>Obergrenze der Vorschubregelung; zunächst das Doppelte des horizontalen Vorschubs der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Centre of the pre-drilled hole</source>
        <translation>Mitte des vorgebohrten Lochs</translation>
    </message>
    <message>
        <source>Centre of the spiral; fitted unless it is set</source>
        <translation>Mitte der Spirale; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Checks each computed path against the job&apos;s models and stock, and refuses one that cuts into a model, or comes down into material by a rapid or a plunge</source>
        <translation>Prüft jede berechnete Bahn gegen Modelle und Rohteil des Auftrags und verweigert eine, die in ein Modell schneidet oder im Eilgang oder senkrecht in Material fährt</translation>
    </message>
    <message>
        <source>Clears only what the job&apos;s earlier operations leave</source>
        <translation>Räumt nur aus, was frühere Operationen des Auftrags übrig lassen</translation>
    </message>
    <message>
        <source>Cuts without a break, at all levels</source>
        <translation>Schnitte ohne Unterbrechung, auf allen Ebenen</translation>
    </message>
    <message>
        <source>Descent of helix and ramp against the level</source>
        <translation>Gefälle von Helix und Rampe gegen die Ebene</translation>
    </message>
    <message>
        <source>Diameter of the pre-drilled hole; there is no hole until it is set</source>
        <translation>Durchmesser des vorgebohrten Lochs; solange er nicht gesetzt ist, gibt es keines</translation>
    </message>
    <message>
        <source>Diameter of the tool centre&apos;s helix; at first 0.9 of the tool&apos;s, and less where that does not fit</source>
        <translation>Durchmesser der Helix der Werkzeugmitte; zunächst das 0.9-Fache des Werkzeugs, und weniger, wo das nicht passt</translation>
    </message>
    <message>
        <source>Direction of the passes against the X axis, seen from above</source>
        <translation>Richtung der Bahnen gegen die X-Achse, von oben gesehen</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes seen from above; the same as the cusp height on a level face: setting one sets the other</source>
        <translation>Abstand benachbarter Bahnen, von oben gesehen; auf einer ebenen Fläche dasselbe wie die Rillenhöhe: das eine setzt das andere</translation>
    </message>
    <message>
        <source>Exponent of the first turn: 1 is an ellipse; fitted unless it is set</source>
        <translation>Exponent der ersten Windung: 1 ist eine Ellipse; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Exponent of the last turn: towards 0 corners grow sharper; fitted unless it is set</source>
        <translation>Exponent der letzten Windung: gegen 0 werden Ecken schärfer; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Feed of links at depth over cleared ground; at first the tool controller&apos;s horizontal rapid feed</source>
        <translation>Vorschub von Verbindungen in der Tiefe über ausgeräumtem Grund; zunächst der horizontale Eilgang der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>First semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>Erste Halbachse der letzten Windung der Spirale, der Werkzeugmitte; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Format of this operation&apos;s properties</source>
        <translation>Format der Eigenschaften dieser Operation</translation>
    </message>
    <message>
        <source>Height of what a ball or a rounded corner leaves between two passes of a level face: setting it sets the stepover; 0 for a flat end mill, which leaves steps</source>
        <translation>Höhe dessen, was eine Kugel oder eine gerundete Ecke zwischen zwei Bahnen einer ebenen Fläche lässt: sie setzt den Bahnabstand; 0 bei einem Schaftfräser, der Stufen lässt</translation>
    </message>
    <message>
        <source>How far links rise above the floor; never above the top</source>
        <translation>Wie weit Verbindungen vom Boden abheben; nie über die Oberseite</translation>
    </message>
    <message>
        <source>How far the trochoid advances in each turn, along the longest slot; 0: no trochoid was repeated, see Report</source>
        <translation>Wie weit die Trochoide je Windung vorrückt, entlang der längsten Nut; 0: keine Trochoide wurde wiederholt, siehe Report</translation>
    </message>
    <message>
        <source>How often the tool rises and comes down again</source>
        <translation>Wie oft das Werkzeug abhebt und wieder eintaucht</translation>
    </message>
    <message>
        <source>How the first semi-axis comes from the first turn to the last: 2 to 20 shares of its change, from 0 to 1, at even steps, as 0; 0.1; 0.4; 1; evenly where it is empty</source>
        <translation>Wie die erste Halbachse von der ersten zur letzten Windung kommt: 2 bis 20 Anteile ihrer Änderung, von 0 bis 1, in gleichen Schritten, wie 0; 0.1; 0.4; 1; leer: gleichmäßig</translation>
    </message>
    <message>
        <source>Largest distance of the output from the exact path; never into a wall</source>
        <translation>Größter Abstand der Ausgabe von der genauen Bahn; nie in eine Wand hinein</translation>
    </message>
    <message>
        <source>Largest engagement angle, mean over 0.1 mm</source>
        <translation>Größter Eingriffswinkel, Mittel über 0.1 mm</translation>
    </message>
    <message>
        <source>Length of cuts and of ways along the surface</source>
        <translation>Länge der Schnitte und der Wege entlang der Fläche</translation>
    </message>
    <message>
        <source>Names of the settings that no longer follow the tool or the geometry</source>
        <translation>Namen der Einstellungen, die nicht mehr dem Werkzeug oder der Geometrie folgen</translation>
    </message>
    <message>
        <source>Of neighbouring passes, seen from above</source>
        <translation>Benachbarter Bahnen, von oben gesehen</translation>
    </message>
    <message>
        <source>Of several regions: each down to its last level, or all level by level</source>
        <translation>Bei mehreren Bereichen: jeden bis zu seiner letzten Ebene, oder alle Ebene für Ebene</translation>
    </message>
    <message>
        <source>Of the first semi-axis against the X axis; fitted unless it is set</source>
        <translation>Der ersten Halbachse gegen die X-Achse; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Passes that were steered to find the shape of that trochoid; 0 for circles and cycloids, and where none was repeated</source>
        <translation>Durchgänge, die gesteuert wurden, um die Form dieser Trochoide zu finden; 0 bei Kreisen und Zykloiden, und wo keine wiederholt wurde</translation>
    </message>
    <message>
        <source>Second semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>Zweite Halbachse der letzten Windung der Spirale, der Werkzeugmitte; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Share of the pocket that the spiral clears, 0 to 1</source>
        <translation>Anteil der Tasche, den die Spirale ausräumt, 0 bis 1</translation>
    </message>
    <message>
        <source>Sides of the curve: 3 for a triangle, 4 for a square or a rectangle; fitted unless it is set</source>
        <translation>Seiten der Kurve: 3 für ein Dreieck, 4 für Quadrat oder Rechteck; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Target and limit of the tool&apos;s engagement angle, between 0 and 180 degrees</source>
        <translation>Ziel und Grenze des Eingriffswinkels, zwischen 0 und 180 Grad</translation>
    </message>
    <message>
        <source>The engagement angle as the side step of a straight cut, r (1 - cos angle): setting one sets the other</source>
        <translation>Der Eingriffswinkel als Seitenzustellung eines geraden Schnitts, r (1 - cos Winkel): das eine setzt das andere</translation>
    </message>
    <message>
        <source>The largest step of a turn; fitted to the engagement angle unless it is set, and smaller where that demands it</source>
        <translation>Der größte Schritt einer Windung; dem Eingriffswinkel angepasst, solange nicht gesetzt, und kleiner, wo dieser es verlangt</translation>
    </message>
    <message>
        <source>The same of the exponent; evenly or late, as is quicker, where it is empty</source>
        <translation>Dasselbe für den Exponenten; leer: gleichmäßig oder spät, was schneller ist</translation>
    </message>
    <message>
        <source>The same of the second semi-axis</source>
        <translation>Dasselbe für die zweite Halbachse</translation>
    </message>
    <message>
        <source>The trochoid&apos;s shape; the circular and the cycloid one reach the engagement angle only for a moment of each turn</source>
        <translation>Die Form der Trochoide; die kreisförmige und die zykloidische erreichen den Eingriffswinkel nur für einen Moment jeder Windung</translation>
    </message>
    <message>
        <source>Time for cuts, links, entries and retracts, in s</source>
        <translation>Zeit für Schnitte, Verbindungen, Eintauchen und Rückzüge, in s</translation>
    </message>
    <message>
        <source>Volume over time along the longest slot at its first depth, links and the passes along both walls included, entry and ends not, in mm3/min</source>
        <translation>Volumen durch Zeit entlang der längsten Nut in ihrer ersten Tiefe, mit Verbindungen und den Durchgängen an beiden Wänden, ohne Eintauchen und Enden, in mm3/min</translation>
    </message>
    <message>
        <source>Volume that the path removes</source>
        <translation>Volumen, das die Bahn abträgt</translation>
    </message>
    <message>
        <source>Ways at depth from cut to cut</source>
        <translation>Wege in der Tiefe von Schnitt zu Schnitt</translation>
    </message>
    <message>
        <source>What has to lie on the picked faces while the tool cuts: the point where it touches, or its axis seen from above</source>
        <translation>Was auf den gewählten Flächen liegen muss, während das Werkzeug schneidet: sein Berührpunkt, oder seine Achse von oben gesehen</translation>
    </message>
    <message>
        <source>What is cut; only Constant force asks for it</source>
        <translation>Was geschnitten wird; nur die konstante Kraft fragt danach</translation>
    </message>
    <message>
        <source>What is done where the width left for the tool&apos;s centre is under twice MinimumRadius</source>
        <translation>Was geschieht, wo die Breite für die Werkzeugmitte unter dem Doppelten des kleinsten Radius liegt</translation>
    </message>
    <message>
        <source>What rest machining depends on: the job&apos;s operations before this one</source>
        <translation>Wovon die Restbearbeitung abhängt: die Operationen des Auftrags vor dieser</translation>
    </message>
    <message>
        <source>What stays above FinalDepth</source>
        <translation>Was über der Endtiefe stehen bleibt</translation>
    </message>
    <message>
        <source>What stays at the walls</source>
        <translation>Was an den Wänden stehen bleibt</translation>
    </message>
    <message>
        <source>What stays on the whole part, measured across its surface</source>
        <translation>Was auf dem ganzen Teil stehen bleibt, quer zur Fläche gemessen</translation>
    </message>
    <message>
        <source>What stays the same where the engagement is below its target</source>
        <translation>Was gleich bleibt, wo der Eingriff unter seinem Ziel liegt</translation>
    </message>
    <message>
        <source>What the spiral does not reach: cleared at constant engagement, or left</source>
        <translation>Was die Spirale nicht erreicht: mit konstantem Eingriff ausgeräumt oder stehen gelassen</translation>
    </message>
    <message>
        <source>What was not done, where and why; the error of a failed operation</source>
        <translation>Was nicht getan wurde, wo und warum; der Fehler einer gescheiterten Operation</translation>
    </message>
    <message>
        <source>Where the feed control would change the feed so often that a program has more blocks per metre of path, it changes it less often, for up to 4 % more time, but not along repeated trochoids or with a least load: for controllers that take few blocks; 0: no limit</source>
        <translation>Wo die Regelung den Vorschub so oft ändern würde, dass ein Programm mehr Sätze je Meter Bahn hätte, ändert sie ihn seltener, für bis zu 4 % mehr Zeit, doch nicht an wiederholten Trochoiden oder mit einer kleinsten Last: für Steuerungen, die wenige Sätze verarbeiten; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Wherever the feed is below MaximumFeed, what the feed control holds is at least this share of its nominal value, as far as moves can be divided: less time, more blocks; 0 to 0.95</source>
        <translation>Wo der Vorschub unter dem größten liegt, beträgt das Geregelte mindestens diesen Anteil seines Nennwerts, soweit sich Bewegungen teilen lassen: weniger Zeit, mehr Sätze; 0 bis 0.95</translation>
    </message>
    <message>
        <source>Which way the cutting edges meet the material, whichever way the spindle turns</source>
        <translation>Wie die Schneiden auf das Material treffen, gleich wie sich die Spindel dreht</translation>
    </message>
    <message>
        <source>Width of the slot round a sketch or edges, which are its centreline once this is set; faces have their own</source>
        <translation>Breite der Nut um eine Skizze oder Kanten, die dann deren Mittellinie sind; Flächen haben ihre eigene</translation>
    </message>
    <message>
        <source>Wished radius of roll-in and roll-out; at first 0.15 of the tool&apos;s diameter</source>
        <translation>Gewünschter Radius des Ein- und Ausrollens; zunächst das 0.15-Fache des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>Wished smallest radius of the path; at first 0.15 of the tool&apos;s diameter</source>
        <translation>Gewünschter kleinster Radius der Bahn; zunächst das 0.15-Fache des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>Radius of the upright arcs by which the tool comes into a pass from the air, and leaves one; smaller where the part is in the way; at first 0.1 of the tool&apos;s diameter</source>
        <translation>Radius der senkrechten Bögen, auf denen das Werkzeug aus der Luft in eine Bahn einfährt und sie verlässt; kleiner, wo das Teil im Weg ist; zunächst das 0.1-Fache des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>The tool first comes in over the open side that is nearest to this place</source>
        <translation>Das Werkzeug kommt zuerst über die offene Seite herein, die dieser Stelle am nächsten liegt</translation>
    </message>
    <message>
        <source>What is the same between all passes: their distance seen from above, or the height of what stands between them</source>
        <translation>Was zwischen allen Bahnen gleich ist: ihr Abstand von oben gesehen, oder die Höhe dessen, was zwischen ihnen stehen bleibt</translation>
    </message>
    <message>
        <source>How far passes go on beyond the border of the faces, seen from above: along what goes on there or falls away, not up what rises</source>
        <translation>Wie weit die Bahnen von oben gesehen über den Rand der Flächen hinausgehen: entlang dessen, was dort weitergeht oder abfällt, nicht hinauf, wo etwas ansteigt</translation>
    </message>
    <message>
        <source>Parallel passes to and fro, or all in one direction with a way back over the part; passes along the outline of the faces, or a spiral round their middle, from the outside or from the inside on; or passes between two picked edges, from the shape of one to the other&apos;s, to and fro or all in one direction</source>
        <translation>Parallele Bahnen hin und her, oder alle in einer Richtung mit einem Rückweg über dem Teil; Bahnen entlang des Umrisses der Flächen, oder eine Spirale um ihre Mitte, von außen oder von innen her; oder Bahnen zwischen zwei gewählten Kanten, von der Form der einen zu der der anderen, hin und her oder alle in einer Richtung</translation>
    </message>
    <message>
        <source>How the tool reaches its depth; Automatic: an open side, else a set hole, else a helix, else a ramp</source>
        <translation>Wie das Werkzeug seine Tiefe erreicht; Automatisch: eine offene Seite, sonst ein gesetztes Loch, sonst eine Helix, sonst eine Rampe</translation>
    </message>
    <message>
        <source>Whether the open side over which the tool first comes in is chosen by a place</source>
        <translation>Ob die offene Seite, über die das Werkzeug zuerst hereinkommt, durch eine Stelle gewählt wird</translation>
    </message>
    <message>
        <source>What stays the same along the cuts: the feed, or the mean thickness of a ball&apos;s chips</source>
        <translation>Was entlang der Schnitte gleich bleibt: der Vorschub oder die mittlere Dicke der Späne einer Kugel</translation>
    </message>
    <message>
        <source>What the cut before has left above the surface that is made, across it: the feed control&apos;s chips are of that; at first 0.03 of the tool&apos;s diameter</source>
        <translation>Was die Bearbeitung davor über der entstehenden Fläche stehen ließ, quer zu ihr: Daraus sind die Späne der Vorschubregelung; zunächst 0,03 des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>Clamps, vices and other objects that the tool keeps off, as from above: what lies below them is not cut. The button takes what is selected</source>
        <translation>Spanneisen, Schraubstöcke und anderes, von dem das Werkzeug wegbleibt, wie von oben: Was darunter liegt, wird nicht bearbeitet. Der Knopf nimmt, was ausgewählt ist</translation>
    </message>
    <message>
        <source>How far the tool stays off the fixtures, all around</source>
        <translation>Wie weit das Werkzeug rundum von den Spannmitteln wegbleibt</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one, the surface&apos;s triangles included; into the part usually a third of it, at the most half</source>
        <translation>Größter Abstand der Bahn von der genauen, die Dreiecke der Fläche eingeschlossen; in das Teil hinein meist ein Drittel davon, höchstens die Hälfte</translation>
    </message>
</context>
<context>
    <name>EvenLoad</name>
    <message>
        <source> (%.2f of the ideal)</source>
        <translation> (%.2f × Ideal)</translation>
    </message>
    <message>
        <source> degrees</source>
        <translation> Grad</translation>
    </message>
    <message>
        <source> up to %1 mm,</source>
        <translation> bis zu %1 mm</translation>
    </message>
    <message>
        <source>%.1f Hz, %.2f %% damping, %.3g N/µm</source>
        <translation>%.1f Hz, %.2f %% Dämpfung, %.3g N/µm</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 and %2 others</source>
        <translation>%1 und %2 andere</translation>
    </message>
    <message>
        <source>%1 and %2 overlap: draw what they enclose together as one, or use two operations.</source>
        <translation>%1 und %2 überlappen sich: was sie zusammen umschließen als eines zeichnen, oder zwei Operationen verwenden.</translation>
    </message>
    <message>
        <source>%1 and Edge%2 of %3</source>
        <translation>%1 und Edge%2 von %3</translation>
    </message>
    <message>
        <source>%1 and Face%2 of %3</source>
        <translation>%1 und Face%2 von %3</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>%1 does not say what its columns are: taken as %2.</source>
        <translation>%1 sagt nicht, was die Spalten sind: genommen als %2.</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Kanten</translation>
    </message>
    <message>
        <source>%1 edges of %2</source>
        <translation>%1 Kanten von %2</translation>
    </message>
    <message>
        <source>%1 encloses no area near (%2, %3): draw it as a closed curve of at least two pieces.</source>
        <translation>%1 umschließt keine Fläche bei (%2, %3): als geschlossene Kurve aus mindestens zwei Stücken zeichnen.</translation>
    </message>
    <message>
        <source>%1 has a coordinate that is not a number, after the point near (%2, %3): draw this piece again.</source>
        <translation>%1 hat eine Koordinate, die keine Zahl ist, nach dem Punkt bei (%2, %3): dieses Stück neu zeichnen.</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1 hat einen Wert, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>%1 has no %2: give it one.</source>
        <translation>%1 hat kein %2: eines angeben.</translation>
    </message>
    <message>
        <source>%1 has no dataset 58, a function at nodal degrees of freedom.</source>
        <translation>%1 hat keinen Datensatz 58, eine Funktion an Knotenfreiheitsgraden.</translation>
    </message>
    <message>
        <source>%1 has no file: give it one.</source>
        <translation>%1 hat keine Datei: eine angeben.</translation>
    </message>
    <message>
        <source>%1 has no lines of frequency, real and imaginary part, or magnitude and phase.</source>
        <translation>%1 hat keine Zeilen mit Frequenz, Real- und Imaginärteil, oder Betrag und Phase.</translation>
    </message>
    <message>
        <source>%1 has no points: measure some.</source>
        <translation>%1 hat keine Punkte: welche messen.</translation>
    </message>
    <message>
        <source>%1 has stock beyond %2 sides without a wall, the first %3</source>
        <translation>%1 hat Rohteil jenseits von %2 Seiten ohne Wand, die erste %3</translation>
    </message>
    <message>
        <source>%1 has stock beyond a side without a wall, %2</source>
        <translation>%1 hat Rohteil jenseits einer Seite ohne Wand, %2</translation>
    </message>
    <message>
        <source>%1 has too few lines: at least four are needed.</source>
        <translation>%1 hat zu wenige Zeilen: mindestens vier sind nötig.</translation>
    </message>
    <message>
        <source>%1 is %2: give an object.</source>
        <translation>%1 ist %2: ein Objekt angeben.</translation>
    </message>
    <message>
        <source>%1 is %2: it %3.</source>
        <translation>%1 ist %2: %3.</translation>
    </message>
    <message>
        <source>%1 is a solid: pick faces of it, or a sketch.</source>
        <translation>%1 ist ein Festkörper: Flächen davon oder eine Skizze wählen.</translation>
    </message>
    <message>
        <source>%1 is no face: pick the faces that are to be finished.</source>
        <translation>%1 ist keine Fläche: die zu schlichtenden Flächen wählen.</translation>
    </message>
    <message>
        <source>%1 is no text: export the points as CSV or DMIS.</source>
        <translation>%1 ist kein Text: die Punkte als CSV oder DMIS exportieren.</translation>
    </message>
    <message>
        <source>%1 is not closed: it ends near (%2, %3): join this end to its start at (%4, %5) in the sketch.</source>
        <translation>%1 ist nicht geschlossen, Ende bei (%2, %3): dieses Ende in der Skizze mit dem Anfang bei (%4, %5) verbinden.</translation>
    </message>
    <message>
        <source>%1 is not flat: pick a flat face parallel to XY.</source>
        <translation>%1 ist nicht eben: eine ebene Fläche parallel zu XY wählen.</translation>
    </message>
    <message>
        <source>%1 is open, the centreline of a slot: set SlotWidth, or close it.</source>
        <translation>%1 ist offen, die Mittellinie einer Nut: [SlotWidth] setzen, oder schließen.</translation>
    </message>
    <message>
        <source>%1 is tilted: pick a face parallel to XY.</source>
        <translation>%1 ist geneigt: eine Fläche parallel zu XY wählen.</translation>
    </message>
    <message>
        <source>%1 lies %2 mm below the underside of the stock: make the stock larger, or move it there.</source>
        <translation>%1 liegt %2 mm unter der Unterseite des Rohteils: das Rohteil vergrößern, oder dorthin verschieben.</translation>
    </message>
    <message>
        <source>%1 lies outside the stock: move it, or make the stock larger.</source>
        <translation>%1 liegt außerhalb des Rohteils: verschieben, oder das Rohteil vergrößern.</translation>
    </message>
    <message>
        <source>%1 lies partly under the model, near (%2, %3), and the rest of it could not be found (%4): draw what is to be cleared as a sketch.</source>
        <translation>%1 liegt zum Teil unter dem Modell, bei (%2, %3), und der Rest davon konnte nicht gefunden werden (%4): was ausgeräumt werden soll, als Skizze zeichnen.</translation>
    </message>
    <message>
        <source>%1 lies partly under the model, near (%2, %3): what is covered is left out.</source>
        <translation>%1 liegt zum Teil unter dem Modell, bei (%2, %3): was bedeckt ist, wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 lies wholly under the model, which stands above it near (%2, %3): no tool reaches it from above. Pick another face.</source>
        <translation>%1 liegt ganz unter dem Modell, das darüber steht bei (%2, %3): kein Werkzeug erreicht sie von oben. Eine andere Fläche wählen.</translation>
    </message>
    <message>
        <source>%1 looks down: pick a face that looks up.</source>
        <translation>%1 zeigt nach unten: eine Fläche wählen, die nach oben zeigt.</translation>
    </message>
    <message>
        <source>%1 looks down: pick faces that look up, or turn the model.</source>
        <translation>%1 zeigt nach unten: Flächen wählen, die nach oben zeigen, oder das Modell drehen.</translation>
    </message>
    <message>
        <source>%1 must be 2 to 20 values that begin with 0, end with 1 and never fall, as 0, 0.1, 0.4, 1.</source>
        <translation>%1 muss 2 bis 20 Werte haben, die mit 0 beginnen, mit 1 enden und nie fallen, wie 0, 0.1, 0.4, 1.</translation>
    </message>
    <message>
        <source>%1 must have either %2 or %3.</source>
        <translation>%1 muss entweder %2 oder %3 haben.</translation>
    </message>
    <message>
        <source>%1 of %2 has a surface that FreeCAD does not tell: leave it out.</source>
        <translation>%1 von %2 hat eine Oberfläche, die FreeCAD nicht nennt: weglassen.</translation>
    </message>
    <message>
        <source>%1 of %2 is no face and no edge: pick a face or a sketch.</source>
        <translation>%1 von %2 ist weder Fläche noch Kante: eine Fläche oder Skizze wählen.</translation>
    </message>
    <message>
        <source>%1 of %2 is no face: pick the faces that are measured.</source>
        <translation>%1 von %2 ist keine Fläche: die gemessenen Flächen wählen.</translation>
    </message>
    <message>
        <source>%1 of %2 is of no model of the job: pick faces of %3.</source>
        <translation>%1 von %2 gehört zu keinem Modell des Auftrags: Flächen von %3 wählen.</translation>
    </message>
    <message>
        <source>%1 of &apos;%2&apos; must be a list.</source>
        <translation>%1 von „%2“ muss eine Liste sein.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be a number above 0, not %3.</source>
        <translation>%1 der Maschine „%2“ muss eine Zahl über 0 sein, nicht %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be a number of 0 or more, not %3.</source>
        <translation>%1 der Maschine „%2“ muss eine Zahl von 0 oder mehr sein, nicht %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be a whole number, not %3.</source>
        <translation>%1 der Maschine „%2“ muss eine ganze Zahl sein, nicht %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be one number above 0, or one each for x, y and z, not %3.</source>
        <translation>%1 der Maschine „%2“ muss eine Zahl über 0 sein, oder je eine für x, y und z, nicht %3.</translation>
    </message>
    <message>
        <source>%1 of the machine &apos;%2&apos; must be the largest, or the least and the largest, not %3.</source>
        <translation>%1 der Maschine „%2“ muss das Größte sein, oder das Kleinste und das Größte, nicht %3.</translation>
    </message>
    <message>
        <source>%1 points fit any face by %2 free motions: measure %3 or more, or leave fewer free.</source>
        <translation>%1 Punkte passen mit %2 freien Bewegungen auf jede Fläche: %3 oder mehr messen, oder weniger frei lassen.</translation>
    </message>
    <message>
        <source>%1 stands upright: finishing comes from above; EvenLoad Adaptive cuts walls.</source>
        <translation>%1 steht senkrecht: Schlichten kommt von oben; EvenLoad Adaptiv schneidet Wände.</translation>
    </message>
    <message>
        <source>%1: %2 cannot be %3.</source>
        <translation>%1: %2 kann nicht %3 sein.</translation>
    </message>
    <message>
        <source>%1: %2 must be a number, not %3.</source>
        <translation>%1: %2 muss eine Zahl sein, nicht %3.</translation>
    </message>
    <message>
        <source>%1: cut down to %2 mm.</source>
        <translation>%1: bis %2 mm geschnitten.</translation>
    </message>
    <message>
        <source>%1: it is cleared no further than %2, for the ground there lies behind walls or belongs to another face or outline of the operation.</source>
        <translation>%1: nicht weiter als %2 wird ausgeräumt, denn der Grund dort liegt hinter Wänden oder gehört zu einer anderen Fläche oder einem anderen Umriss der Operation.</translation>
    </message>
    <message>
        <source>%1: it is cleared to the edge of the stock, up to %2 mm from the face.</source>
        <translation>%1: bis zum Rand des Rohteils wird ausgeräumt, bis zu %2 mm von der Fläche.</translation>
    </message>
    <message>
        <source>%1: it is cleared up to %2 mm from the face, and what lies further out stays.</source>
        <translation>%1: bis zu %2 mm von der Fläche wird ausgeräumt, und was weiter außen liegt, bleibt stehen.</translation>
    </message>
    <message>
        <source>%1: it is not cleared there, for it would meet what is cleared beyond %2.</source>
        <translation>%1: dort wird nicht ausgeräumt, denn es träfe auf das, was jenseits von %2 ausgeräumt wird.</translation>
    </message>
    <message>
        <source>%1: it is not cleared, for the ground there could not be found (%2).</source>
        <translation>%1: dort wird nicht ausgeräumt, denn der Grund dort konnte nicht gefunden werden (%2).</translation>
    </message>
    <message>
        <source>%1: nothing is to be cut down to %2 mm, for the cut begins at %3 mm; raise StartDepth, or take it out of the base geometry.</source>
        <translation>%1: bis %2 mm ist nichts zu schneiden, denn der Schnitt beginnt bei %3 mm; [StartDepth] erhöhen, oder es aus der Basisgeometrie nehmen.</translation>
    </message>
    <message>
        <source>%1: there is no file &apos;%2&apos;.</source>
        <translation>%1: es gibt keine Datei „%2“.</translation>
    </message>
    <message>
        <source>%1: unknown key &apos;%2&apos;; known keys are %3.</source>
        <translation>%1: unbekannter Schlüssel „%2“; bekannt sind %3.</translation>
    </message>
    <message>
        <source>%d points</source>
        <translation>%d Punkte</translation>
    </message>
    <message>
        <source>%s takes numbers, as 0; 0.1; 0.4; 1.</source>
        <translation>%s nimmt Zahlen, wie 0; 0.1; 0.4; 1.</translation>
    </message>
    <message>
        <source>%s was not created: %s</source>
        <translation>%s wurde nicht erstellt: %s</translation>
    </message>
    <message>
        <source>%s: the same tool controller.</source>
        <translation>%s: dieselbe Werkzeugsteuerung.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to no job: create it in one.</source>
        <translation>„%1“ gehört zu keinem Auftrag: in einem erstellen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to no job: put it into one.</source>
        <translation>„%1“ gehört zu keinem Auftrag: in einen legen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cuts nothing: its StartDepth does not lie above its FinalDepth.</source>
        <translation>„%1“ schneidet nichts: [StartDepth] liegt nicht über [FinalDepth].</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no level cut, whose stability could be told.</source>
        <translation>„%1“ hat keinen ebenen Schnitt, dessen Stabilität zu nennen wäre.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no mode: give it modes, or tap_tests to fit them to.</source>
        <translation>„%1“ hat keine Mode: modes angeben, oder tap_tests, an die sie angepasst werden.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no path to simulate: recompute it first.</source>
        <translation>„%1“ hat keine Bahn zum Simulieren: zuerst neu berechnen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no path: recompute it first.</source>
        <translation>„%1“ hat keine Bahn: zuerst neu berechnen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no shape: pick a face or a sketch.</source>
        <translation>„%1“ hat keine Form: eine Fläche oder Skizze wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no spindle speed: set the tool controller&apos;s.</source>
        <translation>„%1“ hat keine Spindeldrehzahl: die der Werkzeugsteuerung setzen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a mesh without faces: make a solid of it (Part, Create Shape from Mesh) first.</source>
        <translation>„%1“ ist ein Netz ohne Flächen: zuerst einen Festkörper daraus machen (Part, Form aus Netz erzeugen).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its tool is %2, which the simulator cannot follow.</source>
        <translation>„%1“ wird weggelassen: sein Werkzeug ist %2, dem der Simulator nicht folgen kann.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; works on %2, which is not of the model: what must stay is not known.</source>
        <translation>„%1“ arbeitet an %2, das nicht zum Modell gehört: was stehen bleiben muss, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, which comes before &apos;%2&apos;, failed: mend it and recompute.</source>
        <translation>„%1“, das vor „%2“ kommt, ist gescheitert: beheben und neu berechnen.</translation>
    </message>
    <message>
        <source>&apos;%s&apos; would send the tool more than 10 m beyond the stock, and its path was emptied: it does not suit &apos;%s&apos;.</source>
        <translation>„%s“ würde das Werkzeug mehr als 10 m über das Rohteil hinaus schicken, und die Bahn wurde geleert: es passt nicht zu „%s“.</translation>
    </message>
    <message>
        <source>, Pattern %1 was not used</source>
        <translation>, [Pattern] %1 wurde nicht benutzt</translation>
    </message>
    <message>
        <source>, for SemiAxisA or SemiAxisB is set</source>
        <translation>, denn [SemiAxisA] oder [SemiAxisB] ist gesetzt</translation>
    </message>
    <message>
        <source>, shares of the nominal load</source>
        <translation>, als Anteil der Nennlast</translation>
    </message>
    <message>
        <source>, too narrow for trochoids</source>
        <translation>, zu eng für Trochoiden</translation>
    </message>
    <message>
        <source>, up to %1 mm deep</source>
        <translation>, bis %1 mm tief</translation>
    </message>
    <message>
        <source>1 tooth</source>
        <translation>1 Zahn</translation>
    </message>
    <message>
        <source>1 tooth and a helix of %1 degrees</source>
        <translation>1 Zahn und einem Drall von %1 Grad</translation>
    </message>
    <message>
        <source>: the channel along its island, from which it begins, takes most of the rest</source>
        <translation>: der Kanal entlang ihrer Insel, von dem sie ausgeht, nimmt das meiste vom Rest</translation>
    </message>
    <message>
        <source>; %1 mm² stay uncut there</source>
        <translation>; %1 mm² bleiben dort stehen</translation>
    </message>
    <message>
        <source>A constant force needs a material that resists: give it a force coefficient above 0.</source>
        <translation>Eine konstante Kraft braucht einen Werkstoff, der Widerstand leistet: ihm einen Kraftkoeffizienten über 0 geben.</translation>
    </message>
    <message>
        <source>A constant force needs the spindle&apos;s speed: set that of the tool controller.</source>
        <translation>Eine konstante Kraft braucht die Spindeldrehzahl: die der Werkzeugsteuerung setzen.</translation>
    </message>
    <message>
        <source>A file may be of more faces than these</source>
        <translation>Eine Datei kann Punkte weiterer Flächen enthalten</translation>
    </message>
    <message>
        <source>A last pass along the walls takes what is left</source>
        <translation>Ein letzter Durchgang entlang der Wände nimmt, was übrig ist</translation>
    </message>
    <message>
        <source>A machine is a name, a JSON file or a dictionary of limits, not %1.</source>
        <translation>Eine Maschine ist ein Name, eine JSON-Datei oder ein Wörterbuch von Grenzen, nicht %1.</translation>
    </message>
    <message>
        <source>A mode was found whose mass is not above 0: ask for fewer modes, or turn the sign of the response.</source>
        <translation>Eine Mode wurde gefunden, deren Masse nicht über 0 liegt: weniger Moden verlangen, oder das Vorzeichen des Frequenzgangs umkehren.</translation>
    </message>
    <message>
        <source>A normal looks down: a probe from above cannot reach its point.</source>
        <translation>Eine Normale zeigt nach unten: ein Taster von oben erreicht ihren Punkt nicht.</translation>
    </message>
    <message>
        <source>A point has a coordinate that is not a number: leave it out.</source>
        <translation>Ein Punkt hat eine Koordinate, die keine Zahl ist: weglassen.</translation>
    </message>
    <message>
        <source>A region has no spiral: with narrow passages it is cleared at constant engagement; set NarrowPassages to &apos;Skip and report&apos; for a spiral.</source>
        <translation>Ein Bereich hat keine Spirale: mit Engstellen wird er mit konstantem Eingriff ausgeräumt; für eine Spirale [NarrowPassages] auf „Auslassen und melden“ setzen.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Adds a mode</source>
        <translation>Fügt eine Mode hinzu</translation>
    </message>
    <message>
        <source>After %1 passes the trochoid&apos;s advance still differed by %2 mm across the slot: the greatest step was taken that keeps the engagement angle.</source>
        <translation>Nach %1 Durchgängen wich der Vorrückweg der Trochoide quer über die Nut noch um %2 mm ab: der größte Schritt wurde genommen, der den Eingriffswinkel hält.</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>All of the file</source>
        <translation>Alle der Datei</translation>
    </message>
    <message>
        <source>All points are nearer to other faces: pick those that were measured.</source>
        <translation>Alle Punkte liegen anderen Flächen näher: die gemessenen wählen.</translation>
    </message>
    <message>
        <source>All points lie on one line: spread them over the faces.</source>
        <translation>Alle Punkte liegen auf einer Geraden: sie über die Flächen verteilen.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Flächenaufmaß</translation>
    </message>
    <message>
        <source>An edge climbs by %1 mm: pick edges and sketches that are parallel to XY.</source>
        <translation>Eine Kante steigt um %1 mm: Kanten und Skizzen parallel zu XY wählen.</translation>
    </message>
    <message>
        <source>An edge has no end: pick edges of finite length.</source>
        <translation>Eine Kante hat kein Ende: Kanten endlicher Länge wählen.</translation>
    </message>
    <message>
        <source>An island crosses or touches itself near (%1, %2): remove the crossing in the sketch.</source>
        <translation>Eine Insel kreuzt oder berührt sich selbst bei (%1, %2): die Kreuzung in der Skizze entfernen.</translation>
    </message>
    <message>
        <source>An island lies inside another island near (%1, %2): remove the inner one, or make it a pocket of its own.</source>
        <translation>Eine Insel liegt in einer anderen bei (%1, %2): die innere entfernen, oder zu einer eigenen Tasche machen.</translation>
    </message>
    <message>
        <source>An island lies outside the outline near (%1, %2): move it inside or remove it.</source>
        <translation>Eine Insel liegt außerhalb des Umrisses bei (%1, %2): hinein verschieben oder entfernen.</translation>
    </message>
    <message>
        <source>Another one beside it on the same scale; each as if the other had cut nothing</source>
        <translation>Eine weitere daneben im selben Maßstab; jede, als hätte die andere nichts geschnitten</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Arc length</source>
        <translation>Bogenlänge</translation>
    </message>
    <message>
        <source>Arcs (G2, G3)</source>
        <translation>Bögen (G2, G3)</translation>
    </message>
    <message>
        <source>Arcs in the output (G2, G3); without, lines only</source>
        <translation>Bögen in der Ausgabe (G2, G3); sonst nur Geraden</translation>
    </message>
    <message>
        <source>Area that the tool could reach and did not clear</source>
        <translation>Fläche, die das Werkzeug erreichen konnte und nicht ausgeräumt hat</translation>
    </message>
    <message>
        <source>As a click into the chart sets it</source>
        <translation>Wie ein Klick ins Diagramm es setzt</translation>
    </message>
    <message>
        <source>As seen from above</source>
        <translation>Von oben gesehen</translation>
    </message>
    <message>
        <source>At a constant feed the uneven turns of this spiral are slow: the feed control &apos;Constant removal rate&apos; or the operation Adaptive is faster.</source>
        <translation>Mit konstantem Vorschub sind die ungleichen Windungen dieser Spirale langsam: die Vorschubregelung „Konst. Zeitspanvolumen“ oder die Operation Adaptiv ist schneller.</translation>
    </message>
    <message>
        <source>At least one mode must be fitted.</source>
        <translation>Mindestens eine Mode muss angepasst werden.</translation>
    </message>
    <message>
        <source>At least so many; fewer than 49 may tell too little</source>
        <translation>Mindestens so viele; weniger als 49 sagen womöglich zu wenig</translation>
    </message>
    <message>
        <source>At, °</source>
        <translation>Bei, °</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Kugelradius</translation>
    </message>
    <message>
        <source>Below %1 Hz the integration of the acceleration drifts: leave these lines out.</source>
        <translation>Unter %1 Hz driftet die Integration der Beschleunigung: diese Linien weglassen.</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Besten suchen</translation>
    </message>
    <message>
        <source>Best cut</source>
        <translation>Bester Schnitt</translation>
    </message>
    <message>
        <source>By minimum zone, with its proof</source>
        <translation>Nach der Minimum-Zone, mit Nachweis</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled before everything was cut.</source>
        <translation>Abgebrochen, bevor alles geschnitten war.</translation>
    </message>
    <message>
        <source>Cancelled before everything was cut: there is no path until it is computed again.</source>
        <translation>Abgebrochen, bevor alles geschnitten war: es gibt keine Bahn, bis sie neu berechnet wird.</translation>
    </message>
    <message>
        <source>Cap of the feed control; at first twice the tool controller&apos;s horizontal feed</source>
        <translation>Obergrenze der Vorschubregelung; zunächst das Doppelte des horizontalen Vorschubs der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Centre must be finite.</source>
        <translation>[Centre] muss endlich sein.</translation>
    </message>
    <message>
        <source>Centre of the pre-drilled hole</source>
        <translation>Mitte des vorgebohrten Lochs</translation>
    </message>
    <message>
        <source>Centre of the spiral; fitted unless it is set</source>
        <translation>Mitte der Spirale; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Changed: Apply computes the path</source>
        <translation>Geändert: Anwenden berechnet die Bahn</translation>
    </message>
    <message>
        <source>Changed: computing the path</source>
        <translation>Geändert: die Bahn wird berechnet</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Check against the model</source>
        <translation>Gegen das Modell prüfen</translation>
    </message>
    <message>
        <source>Checked against the model.</source>
        <translation>Gegen das Modell geprüft.</translation>
    </message>
    <message>
        <source>Checks each computed path against the job&apos;s models and stock, and refuses one that cuts into a model, or comes down into material by a rapid or a plunge</source>
        <translation>Prüft jede berechnete Bahn gegen Modelle und Rohteil des Auftrags und verweigert eine, die in ein Modell schneidet oder im Eilgang oder senkrecht in Material fährt</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Spandicke</translation>
    </message>
    <message>
        <source>Chips get up to %1 times as thick as in a straight cut at the engagement angle, %2: lower MaximumFeed, or choose another FeedControl, where that is too much.</source>
        <translation>Späne werden bis zu %1-mal so dick wie im geraden Schnitt mit dem Eingriffswinkel, %2: [MaximumFeed] senken, oder, wo das zu viel ist, [FeedControl] anders wählen.</translation>
    </message>
    <message>
        <source>Circular</source>
        <translation>Kreisförmig</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Ausräumen</translation>
    </message>
    <message>
        <source>Clearance Height</source>
        <translation>Freifahrhöhe</translation>
    </message>
    <message>
        <source>ClearanceHeight (%1 mm) lies below SafeHeight (%2 mm): raise it.</source>
        <translation>[ClearanceHeight] (%1 mm) liegt unter [SafeHeight] (%2 mm): erhöhen.</translation>
    </message>
    <message>
        <source>Clears only what the job&apos;s earlier operations leave</source>
        <translation>Räumt nur aus, was frühere Operationen des Auftrags übrig lassen</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the window</source>
        <translation>Schließt das Fenster</translation>
    </message>
    <message>
        <source>Colours the path in the 3D view by its load, or ends that</source>
        <translation>Färbt die Bahn in der 3D-Ansicht nach ihrer Belastung, oder beendet das</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Command %1 of the path, %2, %3</source>
        <translation>Befehl %1 der Bahn, %2, %3</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Wird berechnet</translation>
    </message>
    <message>
        <source>Computing the path</source>
        <translation>Die Bahn wird berechnet</translation>
    </message>
    <message>
        <source>Constant chip thickness</source>
        <translation>Konstante Spandicke</translation>
    </message>
    <message>
        <source>Constant cusp height</source>
        <translation>Konstante Rillenhöhe</translation>
    </message>
    <message>
        <source>Constant engagement</source>
        <translation>Konstanter Eingriff</translation>
    </message>
    <message>
        <source>Constant feed</source>
        <translation>Konstanter Vorschub</translation>
    </message>
    <message>
        <source>Constant force</source>
        <translation>Konstante Kraft</translation>
    </message>
    <message>
        <source>Constant removal rate</source>
        <translation>Konst. Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Constant stepover</source>
        <translation>Konstanter Bahnabstand</translation>
    </message>
    <message>
        <source>Contours inwards</source>
        <translation>Konturen nach innen</translation>
    </message>
    <message>
        <source>Contours outwards</source>
        <translation>Konturen nach außen</translation>
    </message>
    <message>
        <source>Conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>Course of A</source>
        <translation>Verlauf von A</translation>
    </message>
    <message>
        <source>Course of B</source>
        <translation>Verlauf von B</translation>
    </message>
    <message>
        <source>Course of exponent</source>
        <translation>Verlauf des Exponenten</translation>
    </message>
    <message>
        <source>Create %s</source>
        <translation>%s erstellen</translation>
    </message>
    <message>
        <source>Cusp height</source>
        <translation>Rillenhöhe</translation>
    </message>
    <message>
        <source>CuspHeight is %1 mm: it must lie between 0 and the %2 mm of the tool&apos;s radius at its end.</source>
        <translation>[CuspHeight] ist %1 mm: muss zwischen 0 und den %2 mm des Werkzeugradius an der Spitze liegen.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut at reduced feed</source>
        <translation>Mit weniger Vorschub</translation>
    </message>
    <message>
        <source>Cut at reduced feed%1: the passage %2, %3 mm wide at its narrowest, with up to %4° engaged, down to %5 mm/min%6.</source>
        <translation>Mit weniger Vorschub geschnitten%1: die Engstelle %2, an der schmalsten Stelle %3 mm breit, mit bis zu %4° Eingriff, bis hinab zu %5 mm/min%6.</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Fräsrichtung</translation>
    </message>
    <message>
        <source>Cuts without a break</source>
        <translation>Schnitte ohne Unterbrechung</translation>
    </message>
    <message>
        <source>Cuts, links, entries and retracts at the path&apos;s own feeds</source>
        <translation>Schnitte, Verbindungen, Eintauchen und Rückzüge mit den Vorschüben der Bahn</translation>
    </message>
    <message>
        <source>Cuts, links, entries and retracts at the path&apos;s own feeds; Cycle Time is the same. The ideal is the area over side step and feed: all of it cut at the engagement angle</source>
        <translation>Schnitte, Verbindungen, Eintauchen und Rückzüge mit den Vorschüben der Bahn; dasselbe ist die Zykluszeit. Das Ideal ist die Fläche durch Seitenzustellung und Vorschub: alles mit dem Eingriffswinkel geschnitten</translation>
    </message>
    <message>
        <source>Cycloid</source>
        <translation>Zykloide</translation>
    </message>
    <message>
        <source>Cylindricity</source>
        <translation>Zylindrizität</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>Damping, %</source>
        <translation>Dämpfung, %</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 ends too early.</source>
        <translation>Datensatz 58 von %1 endet zu früh.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is incomplete or of another kind.</source>
        <translation>Datensatz 58 von %1 ist unvollständig oder von anderer Art.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is no frequency response function.</source>
        <translation>Datensatz 58 von %1 ist kein Frequenzgang.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is no response to a force over frequency.</source>
        <translation>Datensatz 58 von %1 ist keine Antwort auf eine Kraft über der Frequenz.</translation>
    </message>
    <message>
        <source>Dataset 58 of %1 is not complex.</source>
        <translation>Datensatz 58 von %1 ist nicht komplex.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Descent of helix and ramp against the level</source>
        <translation>Gefälle von Helix und Rampe gegen die Ebene</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Diameter of the pre-drilled hole; there is no hole until it is set</source>
        <translation>Durchmesser des vorgebohrten Lochs; solange er nicht gesetzt ist, gibt es keines</translation>
    </message>
    <message>
        <source>Diameter of the probe&apos;s ball</source>
        <translation>Durchmesser der Tastkugel</translation>
    </message>
    <message>
        <source>Diameter of the tool centre&apos;s helix; at first 0.9 of the tool&apos;s, and less where that does not fit</source>
        <translation>Durchmesser der Helix der Werkzeugmitte; zunächst das 0.9-Fache des Werkzeugs, und weniger, wo das nicht passt</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of the passes against the X axis, seen from above</source>
        <translation>Richtung der Bahnen gegen die X-Achse, von oben gesehen</translation>
    </message>
    <message>
        <source>Direction of the vibration, counter-clockwise from machine X</source>
        <translation>Schwingungsrichtung, gegen den Uhrzeigersinn von Maschinen-X</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes seen from above; the same as the cusp height on a level face: setting one sets the other</source>
        <translation>Abstand benachbarter Bahnen, von oben gesehen; auf einer ebenen Fläche dasselbe wie die Rillenhöhe: das eine setzt das andere</translation>
    </message>
    <message>
        <source>Down to</source>
        <translation>Tiefe bis</translation>
    </message>
    <message>
        <source>Draws a line at this engagement angle</source>
        <translation>Zeichnet bei diesem Eingriffswinkel eine Linie</translation>
    </message>
    <message>
        <source>Draws a line at this force</source>
        <translation>Zeichnet bei dieser Kraft eine Linie</translation>
    </message>
    <message>
        <source>Draws a line at this removal rate</source>
        <translation>Zeichnet bei diesem Zeitspanvolumen eine Linie</translation>
    </message>
    <message>
        <source>Draws the deviations</source>
        <translation>Zeichnet die Abweichungen</translation>
    </message>
    <message>
        <source>Draws the plots, PNG or SVG</source>
        <translation>Zeichnet die Diagramme, PNG oder SVG</translation>
    </message>
    <message>
        <source>Draws these points</source>
        <translation>Zeichnet diese Punkte</translation>
    </message>
    <message>
        <source>Dwells of %1 s count in the total times only, not in those of the samples.</source>
        <translation>Verweilzeiten von %1 s zählen nur in den Gesamtzeiten, nicht in denen der einzelnen Stellen.</translation>
    </message>
    <message>
        <source>Each point needs a normal, and a normal needs a length above 0.</source>
        <translation>Jeder Punkt braucht eine Normale, und eine Normale eine Länge über 0.</translation>
    </message>
    <message>
        <source>Each row below the headings holds six numbers.</source>
        <translation>Jede Zeile unter den Überschriften enthält sechs Zahlen.</translation>
    </message>
    <message>
        <source>Edge%1 of %2</source>
        <translation>Edge%1 von %2</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Engagement</source>
        <translation>Eingriff</translation>
    </message>
    <message>
        <source>Engagement angle</source>
        <translation>Eingriffswinkel</translation>
    </message>
    <message>
        <source>Engagement up to %.1f°</source>
        <translation>Eingriff bis %.1f°</translation>
    </message>
    <message>
        <source>Engagement, °</source>
        <translation>Eingriff, °</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>Entry is &apos;Predrilled hole&apos;, but there is no hole: set EntryPoint and HoleDiameter.</source>
        <translation>[Entry] ist „Vorgebohrtes Loch“, aber es gibt keines: [EntryPoint] und [HoleDiameter] setzen.</translation>
    </message>
    <message>
        <source>Entry is a helix, not a ramp: in this pocket the spiral begins as a circle.</source>
        <translation>[Entry] ist eine Helix, keine Rampe: in dieser Tasche beginnt die Spirale als Kreis.</translation>
    </message>
    <message>
        <source>EntryPoint is (%1, %2), outside %3: move it inside.</source>
        <translation>[EntryPoint] ist (%1, %2), außerhalb von %3: hinein verschieben.</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Even along each face, or from above over all</source>
        <translation>Gleichmäßig auf jeder Fläche, oder von oben über alle</translation>
    </message>
    <message>
        <source>EvenLoad Adaptive</source>
        <translation>EvenLoad Adaptiv</translation>
    </message>
    <message>
        <source>EvenLoad Finishing</source>
        <translation>EvenLoad Schlichten</translation>
    </message>
    <message>
        <source>EvenLoad Lamé Spiral</source>
        <translation>EvenLoad Lamé-Spirale</translation>
    </message>
    <message>
        <source>EvenLoad Simulation</source>
        <translation>EvenLoad Simulation</translation>
    </message>
    <message>
        <source>EvenLoad Trochoid</source>
        <translation>EvenLoad Trochoide</translation>
    </message>
    <message>
        <source>EvenLoad failed: %1.</source>
        <translation>EvenLoad ist gescheitert: %1.</translation>
    </message>
    <message>
        <source>EvenLoad&apos;s compiled modules are missing, for %1: %2</source>
        <translation>Die kompilierten Module von EvenLoad fehlen, für %1: %2</translation>
    </message>
    <message>
        <source>EvenLoad&apos;s module %1: %2.</source>
        <translation>EvenLoads Modul %1: %2.</translation>
    </message>
    <message>
        <source>Exponent of the first turn: 1 is an ellipse; fitted unless it is set</source>
        <translation>Exponent der ersten Windung: 1 ist eine Ellipse; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Exponent of the last turn: towards 0 corners grow sharper; fitted unless it is set</source>
        <translation>Exponent der letzten Windung: gegen 0 werden Ecken schärfer; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>ExponentCourse changes nothing: the first and the last exponent are the same.</source>
        <translation>[ExponentCourse] ändert nichts: der erste und der letzte Exponent sind gleich.</translation>
    </message>
    <message>
        <source>ExponentStart and ExponentEnd must lie between 0.05 and 1: above 1 the spiral has corners.</source>
        <translation>[ExponentStart] und [ExponentEnd] müssen zwischen 0.05 und 1 liegen: über 1 hat die Spirale Ecken.</translation>
    </message>
    <message>
        <source>Face%1 of %2</source>
        <translation>Face%1 von %2</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed control</source>
        <translation>Vorschubregelung</translation>
    </message>
    <message>
        <source>Feed of links at depth over cleared ground; at first the tool controller&apos;s horizontal rapid feed</source>
        <translation>Vorschub von Verbindungen in der Tiefe über ausgeräumtem Grund; zunächst der horizontale Eilgang der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Vorschübe</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Final Depth</source>
        <translation>Endtiefe</translation>
    </message>
    <message>
        <source>FinalDepth (%1 mm) keeps the tool&apos;s tip up: lower it if more of the faces is to be reached.</source>
        <translation>[FinalDepth] (%1 mm) hält die Werkzeugspitze oben: senken, wenn mehr von den Flächen erreicht werden soll.</translation>
    </message>
    <message>
        <source>FinalDepth lies %1 mm above %2: the rest stays.</source>
        <translation>[FinalDepth] liegt %1 mm über %2: der Rest bleibt stehen.</translation>
    </message>
    <message>
        <source>FinalDepth lies %1 mm below %2: the tool cuts into it.</source>
        <translation>[FinalDepth] liegt %1 mm unter %2: das Werkzeug schneidet hinein.</translation>
    </message>
    <message>
        <source>FinalDepth lies %1 mm below the underside of the stock.</source>
        <translation>[FinalDepth] liegt %1 mm unter der Unterseite des Rohteils.</translation>
    </message>
    <message>
        <source>Finds the cut that removes most</source>
        <translation>Findet den Schnitt, der am meisten abträgt</translation>
    </message>
    <message>
        <source>First exponent</source>
        <translation>Erster Exponent</translation>
    </message>
    <message>
        <source>First semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>Erste Halbachse der letzten Windung der Spirale, der Werkzeugmitte; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Fit all again</source>
        <translation>Alles neu anpassen</translation>
    </message>
    <message>
        <source>Fits modes to a measured frequency response</source>
        <translation>Passt Moden an einen gemessenen Frequenzgang an</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Ebenheit</translation>
    </message>
    <message>
        <source>Fly to the Worst</source>
        <translation>Zur schlimmsten Stelle</translation>
    </message>
    <message>
        <source>Fly to the worst</source>
        <translation>Zur schlimmsten Stelle</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Kraft, N</translation>
    </message>
    <message>
        <source>Form error</source>
        <translation>Formabweichung</translation>
    </message>
    <message>
        <source>Frequency responses (*.csv *.txt *.unv *.uff *.dat);;All (*)</source>
        <translation>Frequenzgänge (*.csv *.txt *.unv *.uff *.dat);;Alle (*)</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From the border of the faces</source>
        <translation>Vom Rand der Flächen</translation>
    </message>
    <message>
        <source>From the window Stability chart</source>
        <translation>Aus dem Fenster Stabilitätskarte</translation>
    </message>
    <message>
        <source>Halton-Zaremba has no rows that may miss a fillet</source>
        <translation>Halton-Zaremba hat keine Reihen, die eine Verrundung verfehlen könnten</translation>
    </message>
    <message>
        <source>Hammer and sensor</source>
        <translation>Hammer und Sensor</translation>
    </message>
    <message>
        <source>Height of what a ball or a rounded corner leaves between two passes of a level face: setting it sets the stepover; 0 for a flat end mill, which leaves steps</source>
        <translation>Höhe dessen, was eine Kugel oder eine gerundete Ecke zwischen zwei Bahnen einer ebenen Fläche lässt: sie setzt den Bahnabstand; 0 bei einem Schaftfräser, der Stufen lässt</translation>
    </message>
    <message>
        <source>Helix</source>
        <translation>Helix</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Helixwinkel</translation>
    </message>
    <message>
        <source>Helix diameter</source>
        <translation>Helixdurchmesser</translation>
    </message>
    <message>
        <source>HelixDiameter %1 mm was taken as %2 mm: a wider helix would leave a post in its middle.</source>
        <translation>[HelixDiameter] %1 mm wurde als %2 mm genommen: eine weitere Helix ließe in ihrer Mitte einen Zapfen stehen.</translation>
    </message>
    <message>
        <source>Hole at</source>
        <translation>Loch bei</translation>
    </message>
    <message>
        <source>Hole diameter</source>
        <translation>Lochdurchmesser</translation>
    </message>
    <message>
        <source>HoleDiameter (%1 mm) is smaller than the tool&apos;s diameter of %2 mm: drill a larger hole or choose another Entry.</source>
        <translation>[HoleDiameter] (%1 mm) ist kleiner als der Werkzeugdurchmesser von %2 mm: größer bohren oder [Entry] anders wählen.</translation>
    </message>
    <message>
        <source>Horiz. Feed</source>
        <translation>Horiz. Vorschub</translation>
    </message>
    <message>
        <source>How far links rise above the floor; never above the top</source>
        <translation>Wie weit Verbindungen vom Boden abheben; nie über die Oberseite</translation>
    </message>
    <message>
        <source>How far the largest multiplier stays below 1</source>
        <translation>Wie weit der größte Multiplikator unter 1 bleibt</translation>
    </message>
    <message>
        <source>How much of the tool&apos;s side cuts</source>
        <translation>Wie viel der Werkzeugseite schneidet</translation>
    </message>
    <message>
        <source>How often the tool rises and comes down again</source>
        <translation>Wie oft das Werkzeug abhebt und wieder eintaucht</translation>
    </message>
    <message>
        <source>How the first semi-axis comes from the first turn to the last: 2 to 20 shares of its change, from 0 to 1, at even steps, as 0; 0.1; 0.4; 1; evenly where it is empty</source>
        <translation>Wie die erste Halbachse von der ersten zur letzten Windung kommt: 2 bis 20 Anteile ihrer Änderung, von 0 bis 1, in gleichen Schritten, wie 0; 0.1; 0.4; 1; leer: gleichmäßig</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>Vorfälle</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Inspects the faces that are selected</source>
        <translation>Prüft die ausgewählten Flächen</translation>
    </message>
    <message>
        <source>Its force coefficients</source>
        <translation>Seine Schnittkraftkoeffizienten</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Art der Bewegung</translation>
    </message>
    <message>
        <source>Largest cutting force in the plane</source>
        <translation>Größte Schnittkraft in der Ebene</translation>
    </message>
    <message>
        <source>Largest distance of the output from the exact path; never into a wall</source>
        <translation>Größter Abstand der Ausgabe von der genauen Bahn; nie in eine Wand hinein</translation>
    </message>
    <message>
        <source>Largest engagement angle, mean over 0.1 mm of the path</source>
        <translation>Größter Eingriffswinkel, Mittel über 0.1 mm der Bahn</translation>
    </message>
    <message>
        <source>Largest error of the wall&apos;s place</source>
        <translation>Größter Fehler der Wandlage</translation>
    </message>
    <message>
        <source>Last exponent</source>
        <translation>Letzter Exponent</translation>
    </message>
    <message>
        <source>Least load</source>
        <translation>Kleinste Last</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Stehen lassen</translation>
    </message>
    <message>
        <source>Left uncut: %1 mm² %2, for the turned-off WallPass, or where the tool has too little room to turn.</source>
        <translation>Stehen geblieben: %1 mm² %2, wegen [WallPass], der ausgeschaltet ist, oder wo das Werkzeug zu wenig Raum zum Drehen hat.</translation>
    </message>
    <message>
        <source>Left uncut: %1 mm² %2, where the tool has too little room to turn within the engagement limit.</source>
        <translation>Stehen geblieben: %1 mm² %2, wo das Werkzeug zu wenig Raum hat, um innerhalb der Eingriffsgrenze zu drehen.</translation>
    </message>
    <message>
        <source>Left uncut: %1 mm² that the spiral does not reach, for Rest is &apos;Leave&apos;.</source>
        <translation>Stehen geblieben: %1 mm², die die Spirale nicht erreicht, denn [Rest] ist „Stehen lassen“.</translation>
    </message>
    <message>
        <source>Length of cuts and of ways along the surface</source>
        <translation>Länge der Schnitte und der Wege entlang der Fläche</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Verbindungsvorschub</translation>
    </message>
    <message>
        <source>Link lift</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>Live-Vorschau</translation>
    </message>
    <message>
        <source>Load a tap test, open a file with modes, or add a mode: the chart follows from what vibrates at the tool&apos;s tip.</source>
        <translation>Einen Klopftest laden, eine Datei mit Moden öffnen oder eine Mode hinzufügen: das Diagramm folgt aus dem, was an der Werkzeugspitze schwingt.</translation>
    </message>
    <message>
        <source>Load of %s</source>
        <translation>Belastung von %s</translation>
    </message>
    <message>
        <source>Location error</source>
        <translation>Lagefehler</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Made from the models themselves: the path keeps off all of the job&apos;s.</source>
        <translation>Aus den Modellen selbst gemacht: die Bahn bleibt von allen des Auftrags weg.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Material stands%1 above StartDepth (%2 mm), near (%3, %4): raise StartDepth, or clear it before.</source>
        <translation>Material steht%1 über [StartDepth] (%2 mm), bei (%3, %4): [StartDepth] erhöhen, oder es vorher ausräumen.</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Maximum feed</source>
        <translation>Größter Vorschub</translation>
    </message>
    <message>
        <source>MaximumFeed is %1 mm/min: it must not be below the tool controller&apos;s horizontal feed of %2 mm/min.</source>
        <translation>[MaximumFeed] ist %1 mm/min: darf nicht unter dem horizontalen Vorschub der Werkzeugsteuerung von %2 mm/min liegen.</translation>
    </message>
    <message>
        <source>Minimum radius</source>
        <translation>Kleinster Radius</translation>
    </message>
    <message>
        <source>Mode %1 of &apos;%2&apos;</source>
        <translation>Mode %1 von „%2“</translation>
    </message>
    <message>
        <source>Mode %d: %s</source>
        <translation>Mode %d: %s</translation>
    </message>
    <message>
        <source>Mode %d: &apos;%s&apos; is no number.</source>
        <translation>Mode %d: „%s“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Moden</translation>
    </message>
    <message>
        <source>Modes are a JSON file, an object or a list of modes, not %1.</source>
        <translation>Moden sind eine JSON-Datei, ein Objekt oder eine Liste von Moden, nicht %1.</translation>
    </message>
    <message>
        <source>Modes of vibration</source>
        <translation>Schwingungsmoden</translation>
    </message>
    <message>
        <source>More than two edges meet at (%1, %2): leave only the outline&apos;s own, without doubles.</source>
        <translation>Mehr als zwei Kanten treffen sich bei (%1, %2): nur die des Umrisses lassen, ohne Doppelte.</translation>
    </message>
    <message>
        <source>Most blocks per metre</source>
        <translation>Höchstens Sätze je Meter</translation>
    </message>
    <message>
        <source>Moves the tool along the path</source>
        <translation>Bewegt das Werkzeug entlang der Bahn</translation>
    </message>
    <message>
        <source>Narrow passages</source>
        <translation>Engstellen</translation>
    </message>
    <message>
        <source>Natural frequency</source>
        <translation>Eigenfrequenz</translation>
    </message>
    <message>
        <source>No cut in the chart keeps the limits.</source>
        <translation>Kein Schnitt im Diagramm hält die Grenzen ein.</translation>
    </message>
    <message>
        <source>No cut leads on from a ramp: the tool comes down by a helix instead.</source>
        <translation>Von einer Rampe führt kein Schnitt weiter: das Werkzeug taucht stattdessen in einer Helix ein.</translation>
    </message>
    <message>
        <source>No face is picked: pick the faces that are measured.</source>
        <translation>Keine Fläche gewählt: die gemessenen Flächen wählen.</translation>
    </message>
    <message>
        <source>No feed down to a tenth of the nominal keeps the force at that of a straight cut at the engagement angle %1: raise EngagementAngle or HorizFeed, or choose another FeedControl.</source>
        <translation>Kein Vorschub bis hinab zu einem Zehntel des Nennwerts hält die Kraft auf der eines geraden Schnitts mit dem Eingriffswinkel %1: [EngagementAngle] oder [HorizFeed] erhöhen, oder [FeedControl] anders wählen.</translation>
    </message>
    <message>
        <source>No file is open.</source>
        <translation>Keine Datei geöffnet.</translation>
    </message>
    <message>
        <source>No helix fits: the tool comes down along a ramp instead.</source>
        <translation>Keine Helix passt: das Werkzeug taucht stattdessen entlang einer Rampe ein.</translation>
    </message>
    <message>
        <source>No spiral was made: with narrow passages it is cleared at constant engagement; set NarrowPassages to &apos;Skip and report&apos; for a spiral.</source>
        <translation>Keine Spirale entstand: mit Engstellen wird mit konstantem Eingriff ausgeräumt; für eine Spirale [NarrowPassages] auf „Auslassen und melden“ setzen.</translation>
    </message>
    <message>
        <source>No trochoid was repeated %1, %2: this region was cleared pass by pass%3.</source>
        <translation>Keine Trochoide wurde wiederholt %1, %2: dieser Bereich wurde Durchgang für Durchgang ausgeräumt%3.</translation>
    </message>
    <message>
        <source>No vertical line meets the faces within the margin: take a smaller one, or space the points by arc length.</source>
        <translation>Keine senkrechte Linie trifft die Flächen innerhalb des Rands: einen kleineren nehmen, oder nach Bogenlänge verteilen.</translation>
    </message>
    <message>
        <source>No zone near by is narrower (contacts: %1; balance of their forces: %2).</source>
        <translation>Keine Zone in der Nähe ist schmaler (Kontakte: %1; Gleichgewicht ihrer Kräfte: %2).</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>None of the picked faces can be seen from above: pick others, or turn the model.</source>
        <translation>Keine der gewählten Flächen ist von oben zu sehen: andere wählen, oder das Modell drehen.</translation>
    </message>
    <message>
        <source>None: programmed feeds</source>
        <translation>Keine: programmierte Vorschübe</translation>
    </message>
    <message>
        <source>Not active: there is no path</source>
        <translation>Nicht aktiv: es gibt keine Bahn</translation>
    </message>
    <message>
        <source>Not checked against the model: Check is off.</source>
        <translation>Nicht gegen das Modell geprüft: [Check] ist aus.</translation>
    </message>
    <message>
        <source>Not computed yet: Apply computes the path</source>
        <translation>Noch nicht berechnet: Anwenden berechnet die Bahn</translation>
    </message>
    <message>
        <source>Nothing was left to cut: earlier cuts have cleared all that this tool can reach.</source>
        <translation>Nichts war mehr zu schneiden: frühere Schnitte haben alles ausgeräumt, was dieses Werkzeug erreicht.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Of a file that holds centres of the probe&apos;s ball</source>
        <translation>Einer Datei mit Mittelpunkten der Tastkugel</translation>
    </message>
    <message>
        <source>Of several regions: each down to its last level, or all level by level</source>
        <translation>Bei mehreren Bereichen: jeden bis zu seiner letzten Ebene, oder alle Ebene für Ebene</translation>
    </message>
    <message>
        <source>Of the first semi-axis against the X axis; fitted unless it is set</source>
        <translation>Der ersten Halbachse gegen die X-Achse; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Of the probing program</source>
        <translation>Des Messprogramms</translation>
    </message>
    <message>
        <source>Of the tool&apos;s flank on the wall it has cut; some 100 kN/m, more with a worn edge</source>
        <translation>Der Freifläche an der geschnittenen Wand; etwa 100 kN/m, mehr bei verschlissener Schneide</translation>
    </message>
    <message>
        <source>Of these faces alone</source>
        <translation>Nur dieser Flächen</translation>
    </message>
    <message>
        <source>On the machine</source>
        <translation>Auf der Maschine</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Eine Richtung</translation>
    </message>
    <message>
        <source>Only a profile has free motions or a datum: take these out.</source>
        <translation>Nur ein Profil hat freie Bewegungen oder einen Bezug: diese weglassen.</translation>
    </message>
    <message>
        <source>Open Machine Profile</source>
        <translation>Maschinenprofil öffnen</translation>
    </message>
    <message>
        <source>Open Measured Points</source>
        <translation>Gemessene Punkte öffnen</translation>
    </message>
    <message>
        <source>Open a tap test</source>
        <translation>Klopftest öffnen</translation>
    </message>
    <message>
        <source>Open modes</source>
        <translation>Moden öffnen</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>OpenCASCADE could not triangulate the shape: %1.</source>
        <translation>OpenCASCADE konnte die Form nicht in Dreiecke zerlegen: %1.</translation>
    </message>
    <message>
        <source>OpenCASCADE could not work on the shape: %1.</source>
        <translation>OpenCASCADE konnte die Form nicht bearbeiten: %1.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Order by</source>
        <translation>Reihenfolge nach</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Passes %d</source>
        <translation>Bahnen %d</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Path %s</source>
        <translation>Bahn %s</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Windungsabstand</translation>
    </message>
    <message>
        <source>Pitch is smaller than set in some turns, down to %1 mm: the engagement angle allows no more there.</source>
        <translation>[Pitch] ist in manchen Windungen kleiner als gesetzt, bis hinab zu %1 mm: mehr erlaubt der Eingriffswinkel dort nicht.</translation>
    </message>
    <message>
        <source>Pitch must be positive.</source>
        <translation>[Pitch] muss positiv sein.</translation>
    </message>
    <message>
        <source>Point %1 has a coordinate that is not a number: leave it out.</source>
        <translation>Punkt %1 hat eine Koordinate, die keine Zahl ist: weglassen.</translation>
    </message>
    <message>
        <source>Point %1 lies %2 mm from the faces: pick the faces that were measured, align the points with the model, or leave it out.</source>
        <translation>Punkt %1 liegt %2 mm von den Flächen entfernt: die gemessenen Flächen wählen, die Punkte am Modell ausrichten, oder ihn weglassen.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points are rows of %1 numbers.</source>
        <translation>Punkte sind Zeilen von %1 Zahlen.</translation>
    </message>
    <message>
        <source>Points nearer to other faces, left out: %1.</source>
        <translation>Punkte, die anderen Flächen näher liegen, weggelassen: %1.</translation>
    </message>
    <message>
        <source>Points…</source>
        <translation>Punkte…</translation>
    </message>
    <message>
        <source>Post-processor</source>
        <translation>Postprozessor</translation>
    </message>
    <message>
        <source>Predrilled hole</source>
        <translation>Vorgebohrtes Loch</translation>
    </message>
    <message>
        <source>Preview: Apply checks and stores the path</source>
        <translation>Vorschau: Anwenden prüft und speichert die Bahn</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>Probing Program…</source>
        <translation>Messprogramm…</translation>
    </message>
    <message>
        <source>Process damping</source>
        <translation>Prozessdämpfung</translation>
    </message>
    <message>
        <source>Python %1 and OpenCASCADE %2</source>
        <translation>Python %1 und OpenCASCADE %2</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Reads measured points, CSV or DMIS</source>
        <translation>Liest gemessene Punkte, CSV oder DMIS</translation>
    </message>
    <message>
        <source>Reads modes from a file</source>
        <translation>Liest Moden aus einer Datei</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Remarks (%d)</source>
        <translation>Bemerkungen (%d)</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected modes</source>
        <translation>Entfernt die ausgewählten Moden</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Übriges</translation>
    </message>
    <message>
        <source>Rest machining</source>
        <translation>Restbearbeitung</translation>
    </message>
    <message>
        <source>Retracts %d</source>
        <translation>Rückzüge %d</translation>
    </message>
    <message>
        <source>Roll radius</source>
        <translation>Einrollradius</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotation must be finite.</source>
        <translation>[Rotation] muss endlich sein.</translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation>Rundheit</translation>
    </message>
    <message>
        <source>Safe Height</source>
        <translation>Sichere Höhe</translation>
    </message>
    <message>
        <source>SafeHeight (%1 mm) lies below StartDepth (%2 mm): raise it.</source>
        <translation>[SafeHeight] (%1 mm) liegt unter [StartDepth] (%2 mm): erhöhen.</translation>
    </message>
    <message>
        <source>SafeHeight (%1 mm) lies below the top of the models (%2 mm): raise it.</source>
        <translation>[SafeHeight] (%1 mm) liegt unter der Oberseite der Modelle (%2 mm): erhöhen.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Save Points</source>
        <translation>Punkte speichern</translation>
    </message>
    <message>
        <source>Save Probing Program</source>
        <translation>Messprogramm speichern</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Save modes</source>
        <translation>Moden speichern</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Wird gesucht</translation>
    </message>
    <message>
        <source>Second semi-axis of the spiral&apos;s last turn, of the tool&apos;s centre; fitted unless it is set</source>
        <translation>Zweite Halbachse der letzten Windung der Spirale, der Werkzeugmitte; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Segments must lie between 3 and 12.</source>
        <translation>[Segments]: muss zwischen 3 und 12 liegen.</translation>
    </message>
    <message>
        <source>Select level faces, closed edges or sketches.</source>
        <translation>Ebene Flächen, geschlossene Kanten oder Skizzen auswählen.</translation>
    </message>
    <message>
        <source>Semi-axes of two lengths need Segments 4: set both to the same length, or leave one unset.</source>
        <translation>Halbachsen zweier Längen brauchen 4 bei [Segments]: beide gleich lang setzen, oder eine nicht setzen.</translation>
    </message>
    <message>
        <source>Semi-axis A</source>
        <translation>Halbachse A</translation>
    </message>
    <message>
        <source>Semi-axis B</source>
        <translation>Halbachse B</translation>
    </message>
    <message>
        <source>SemiAxisA and SemiAxisB must be positive lengths.</source>
        <translation>[SemiAxisA] und [SemiAxisB] müssen positive Längen sein.</translation>
    </message>
    <message>
        <source>Sets spindle speed, feeds, step down and cut mode</source>
        <translation>Setzt Spindeldrehzahl, Vorschübe, Zustelltiefe und Fräsrichtung</translation>
    </message>
    <message>
        <source>Shows all of the time</source>
        <translation>Zeigt die ganze Zeit</translation>
    </message>
    <message>
        <source>Shows the path in the 3D view while values change</source>
        <translation>Zeigt die Bahn in der 3D-Ansicht, während sich Werte ändern</translation>
    </message>
    <message>
        <source>Shows the place with the largest value</source>
        <translation>Zeigt die Stelle mit dem größten Wert</translation>
    </message>
    <message>
        <source>Side step</source>
        <translation>Seitenzustellung</translation>
    </message>
    <message>
        <source>SideStep is %1 mm: it must lie between 0 and the tool&apos;s diameter of %2 mm.</source>
        <translation>[SideStep] ist %1 mm: muss zwischen 0 und dem Werkzeugdurchmesser von %2 mm liegen.</translation>
    </message>
    <message>
        <source>Sides of the curve: 3 for a triangle, 4 for a square or a rectangle; fitted unless it is set</source>
        <translation>Seiten der Kurve: 3 für ein Dreieck, 4 für Quadrat oder Rechteck; angepasst, solange nicht gesetzt</translation>
    </message>
    <message>
        <source>Simulates the job and writes a report to print, HTML</source>
        <translation>Simuliert den Auftrag und schreibt einen druckbaren Bericht, HTML</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Skip and report</source>
        <translation>Auslassen und melden</translation>
    </message>
    <message>
        <source>Skipped%1: the passage %2, %3 mm wide at its narrowest%4.</source>
        <translation>Ausgelassen%1: die Engstelle %2, an der schmalsten Stelle %3 mm breit%4.</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Nut</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>Nutbreite</translation>
    </message>
    <message>
        <source>SlotWidth (%1 mm) is less than the tool&apos;s diameter of %2 mm: take a smaller tool or widen the slot.</source>
        <translation>[SlotWidth] (%1 mm) ist weniger als der Werkzeugdurchmesser von %2 mm: ein kleineres Werkzeug nehmen oder die Nut verbreitern.</translation>
    </message>
    <message>
        <source>SlotWidth was not used for %1: a face has its own width.</source>
        <translation>[SlotWidth] wurde nicht benutzt für %1: eine Fläche hat ihre eigene Breite.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Aufteilung</translation>
    </message>
    <message>
        <source>Spacing is &apos;%1&apos;, but the tool &apos;%2&apos; has a flat end, which leaves steps: take a ball end mill, or another Spacing.</source>
        <translation>[Spacing] ist „%1“, aber das Werkzeug „%2“ hat ein flaches Ende, das Stufen lässt: einen Kugelfräser nehmen, oder [Spacing] anders wählen.</translation>
    </message>
    <message>
        <source>Sphericity</source>
        <translation>Kugelform</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Stability chart</source>
        <translation>Stabilitätskarte</translation>
    </message>
    <message>
        <source>Start Depth</source>
        <translation>Starttiefe</translation>
    </message>
    <message>
        <source>StartDepth (%1 mm) does not lie above FinalDepth (%2 mm): raise StartDepth or lower FinalDepth.</source>
        <translation>[StartDepth] (%1 mm) liegt nicht über [FinalDepth] (%2 mm): [StartDepth] erhöhen oder [FinalDepth] senken.</translation>
    </message>
    <message>
        <source>StartDepth (%1 mm) does not lie above the underside of the stock (%2 mm): there is nothing to cut.</source>
        <translation>[StartDepth] (%1 mm) liegt nicht über der Unterseite des Rohteils (%2 mm): es gibt nichts zu schneiden.</translation>
    </message>
    <message>
        <source>Stays on the faces</source>
        <translation>Bleibt auf den Flächen</translation>
    </message>
    <message>
        <source>Step Down</source>
        <translation>Zustelltiefe</translation>
    </message>
    <message>
        <source>Step down</source>
        <translation>Zustelltiefe</translation>
    </message>
    <message>
        <source>StepDown is %1 mm: from StartDepth to FinalDepth that makes more than %2 levels, raise it.</source>
        <translation>[StepDown] ist %1 mm: von [StartDepth] bis [FinalDepth] ergibt das mehr als %2 Ebenen, erhöhen.</translation>
    </message>
    <message>
        <source>StepDown is %1 mm: it must be positive.</source>
        <translation>[StepDown] ist %1 mm: muss positiv sein.</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Bahnabstand</translation>
    </message>
    <message>
        <source>Stepover is %1 mm, more than the tool&apos;s diameter of %2 mm: lower it.</source>
        <translation>[Stepover] ist %1 mm, mehr als der Werkzeugdurchmesser von %2 mm: senken.</translation>
    </message>
    <message>
        <source>Stiffness of the mode</source>
        <translation>Steifigkeit der Mode</translation>
    </message>
    <message>
        <source>Stock at the floor</source>
        <translation>Aufmaß am Boden</translation>
    </message>
    <message>
        <source>Stock to leave</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>StockToLeaveAxial is %1 mm: between StartDepth (%2 mm) and FinalDepth (%3 mm) that leaves nothing to cut, lower it.</source>
        <translation>[StockToLeaveAxial] ist %1 mm: zwischen [StartDepth] (%2 mm) und [FinalDepth] (%3 mm) bleibt damit nichts zu schneiden, senken.</translation>
    </message>
    <message>
        <source>Stops the simulation</source>
        <translation>Bricht die Simulation ab</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Geradheit</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabelle…</translation>
    </message>
    <message>
        <source>Take Selected Faces</source>
        <translation>Ausgewählte Flächen übernehmen</translation>
    </message>
    <message>
        <source>Tap test</source>
        <translation>Klopftest</translation>
    </message>
    <message>
        <source>Tap test %1 of &apos;%2&apos;</source>
        <translation>Klopftest %1 von „%2“</translation>
    </message>
    <message>
        <source>Tap test...</source>
        <translation>Klopftest...</translation>
    </message>
    <message>
        <source>Target and limit of the tool&apos;s engagement angle, between 0 and 180 degrees</source>
        <translation>Ziel und Grenze des Eingriffswinkels, zwischen 0 und 180 Grad</translation>
    </message>
    <message>
        <source>That it is the narrowest zone is not proved: take it for an upper bound.</source>
        <translation>Dass es die schmalste Zone ist, ist nicht bewiesen: als obere Schranke nehmen.</translation>
    </message>
    <message>
        <source>The %1 feed of the tool controller &apos;%2&apos; is 0: set its %3.</source>
        <translation>Der Vorschub (%1) der Werkzeugsteuerung „%2“ ist 0: %3 setzen.</translation>
    </message>
    <message>
        <source>The %1 must be above 0, not %2.</source>
        <translation>Muss über 0 liegen, nicht bei %2: %1.</translation>
    </message>
    <message>
        <source>The chart is that of this cut mode</source>
        <translation>Das Diagramm gilt für diese Fräsrichtung</translation>
    </message>
    <message>
        <source>The chart&apos;s largest depth</source>
        <translation>Größte Tiefe des Diagramms</translation>
    </message>
    <message>
        <source>The chart&apos;s largest spindle speed</source>
        <translation>Größte Spindeldrehzahl des Diagramms</translation>
    </message>
    <message>
        <source>The chart&apos;s least spindle speed</source>
        <translation>Kleinste Spindeldrehzahl des Diagramms</translation>
    </message>
    <message>
        <source>The chart&apos;s speeds must rise.</source>
        <translation>Die Drehzahlen des Diagramms müssen steigen.</translation>
    </message>
    <message>
        <source>The coherence around %1 Hz falls to %2: measure it again.</source>
        <translation>Die Kohärenz um %1 Hz fällt auf %2: noch einmal messen.</translation>
    </message>
    <message>
        <source>The cut is stable at %1 rev/min and %2 mm%3.</source>
        <translation>Der Schnitt ist stabil bei %1 U/min und %2 mm%3.</translation>
    </message>
    <message>
        <source>The cut is unstable: %1 mm deep at %2 rev/min it chatters near %3 Hz, worst where the feed is at %4° to X; %5.</source>
        <translation>Der Schnitt ist instabil: %1 mm tief bei %2 U/min rattert er nahe %3 Hz, am schlimmsten, wo der Vorschub in %4° zu X steht; %5.</translation>
    </message>
    <message>
        <source>The datum is one plane face, not %1.</source>
        <translation>Der Bezug ist eine ebene Fläche, nicht %1.</translation>
    </message>
    <message>
        <source>The deflection and the angle must be positive.</source>
        <translation>Abweichung und Winkel müssen positiv sein.</translation>
    </message>
    <message>
        <source>The depth of %1 mm is beyond the tool&apos;s flutes, %2 mm.</source>
        <translation>Die Tiefe von %1 mm geht über die Schneiden des Werkzeugs hinaus, %2 mm.</translation>
    </message>
    <message>
        <source>The depth of %1 mm is more than the cutting length of %2 mm of the tool &apos;%3&apos;: take a longer tool or raise FinalDepth.</source>
        <translation>Die Tiefe von %1 mm ist mehr als die Schneidenlänge von %2 mm des Werkzeugs „%3“: ein längeres nehmen oder [FinalDepth] erhöhen.</translation>
    </message>
    <message>
        <source>The diameter of the tool &apos;%1&apos; is %2 mm: set it.</source>
        <translation>Der Durchmesser des Werkzeugs „%1“ ist %2 mm: setzen.</translation>
    </message>
    <message>
        <source>The engagement angle as the side step of a straight cut, r (1 - cos angle): setting one sets the other</source>
        <translation>Der Eingriffswinkel als Seitenzustellung eines geraden Schnitts, r (1 - cos Winkel): das eine setzt das andere</translation>
    </message>
    <message>
        <source>The engagement angle of &apos;%1&apos; is %2°: it must lie above 0, where nothing is cut, and at most at 180°.</source>
        <translation>Der Eingriffswinkel von „%1“ ist %2°: er muss über 0 liegen, wo nichts geschnitten wird, und höchstens bei 180°.</translation>
    </message>
    <message>
        <source>The expression of %1, &apos;%2&apos;, cannot be evaluated: mend it.</source>
        <translation>Der Ausdruck von %1, „%2“, kann nicht ausgewertet werden: beheben.</translation>
    </message>
    <message>
        <source>The face has no boundary: pick a finite one.</source>
        <translation>Die Fläche hat keinen Rand: eine endliche wählen.</translation>
    </message>
    <message>
        <source>The face is not flat: pick a flat face that is parallel to XY.</source>
        <translation>Die Fläche ist nicht eben: eine ebene Fläche parallel zu XY wählen.</translation>
    </message>
    <message>
        <source>The face is tilted by %1 degrees: pick one that is parallel to XY.</source>
        <translation>Die Fläche ist um %1 Grad geneigt: eine parallel zu XY wählen.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; must hold one %2, a JSON object.</source>
        <translation>Die Datei „%1“ muss ein %2 enthalten, ein JSON-Objekt.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of the %2 cannot be read: %3.</source>
        <translation>Die Datei „%1“ (%2) kann nicht gelesen werden: %3.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of the %2 is no JSON: %3.</source>
        <translation>Die Datei „%1“ (%2) ist kein JSON: %3.</translation>
    </message>
    <message>
        <source>The file cannot be written (%s): name another one.</source>
        <translation>Die Datei kann nicht geschrieben werden (%s): einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>The file has no measured points, FA(name)=FEAT/POINT,CART.</source>
        <translation>Die Datei hat keine gemessenen Punkte, FA(name)=FEAT/POINT,CART.</translation>
    </message>
    <message>
        <source>The file is empty: it needs the headings x [mm], y [mm], z [mm], i, j, k.</source>
        <translation>Die Datei ist leer: sie braucht die Überschriften x [mm], y [mm], z [mm], i, j, k.</translation>
    </message>
    <message>
        <source>The file mixes mm and inch: write it anew in one unit.</source>
        <translation>Die Datei mischt mm und inch: in einer Einheit neu schreiben.</translation>
    </message>
    <message>
        <source>The file states no unit before its points: add UNITS/MM or UNITS/INCH.</source>
        <translation>Die Datei nennt vor ihren Punkten keine Einheit: UNITS/MM oder UNITS/INCH ergänzen.</translation>
    </message>
    <message>
        <source>The frequencies of %1 do not rise from line to line.</source>
        <translation>Die Frequenzen von %1 steigen nicht von Zeile zu Zeile.</translation>
    </message>
    <message>
        <source>The frequencies of the response must be numbers from 0 on.</source>
        <translation>Die Frequenzen des Frequenzgangs müssen Zahlen ab 0 sein.</translation>
    </message>
    <message>
        <source>The frequencies of the response must rise from line to line.</source>
        <translation>Die Frequenzen des Frequenzgangs müssen von Zeile zu Zeile steigen.</translation>
    </message>
    <message>
        <source>The frequency of a mode must be a number of Hz above 0.</source>
        <translation>Die Frequenz einer Mode muss eine Zahl in Hz über 0 sein.</translation>
    </message>
    <message>
        <source>The frequency response has too few lines for so many modes.</source>
        <translation>Der Frequenzgang hat für so viele Moden zu wenige Linien.</translation>
    </message>
    <message>
        <source>The headings are x [mm], y [mm], z [mm], i, j, k, with mm or inch.</source>
        <translation>Die Überschriften sind x [mm], y [mm], z [mm], i, j, k, mit mm oder inch.</translation>
    </message>
    <message>
        <source>The headings of x, y and z state different units: state one.</source>
        <translation>Die Überschriften von x, y und z nennen verschiedene Einheiten: eine nennen.</translation>
    </message>
    <message>
        <source>The imaginary part is positive at the peak at %1 Hz: the sign, or the unit, is wrong.</source>
        <translation>Der Imaginärteil ist an der Spitze bei %1 Hz positiv: Vorzeichen oder Einheit sind falsch.</translation>
    </message>
    <message>
        <source>The job &apos;%1&apos; has no model: add one to it.</source>
        <translation>Der Auftrag „%1“ hat kein Modell: eines hinzufügen.</translation>
    </message>
    <message>
        <source>The job &apos;%1&apos; has no stock: give it one.</source>
        <translation>Der Auftrag „%1“ hat kein Rohteil: ihm eines geben.</translation>
    </message>
    <message>
        <source>The job has no operation with a tool: create one first.</source>
        <translation>Der Auftrag hat keine Operation mit Werkzeug: zuerst eine erstellen.</translation>
    </message>
    <message>
        <source>The largest step of a turn; fitted to the engagement angle unless it is set, and smaller where that demands it</source>
        <translation>Der größte Schritt einer Windung; dem Eingriffswinkel angepasst, solange nicht gesetzt, und kleiner, wo dieser es verlangt</translation>
    </message>
    <message>
        <source>The machine &apos;%1&apos; has no %2: give it one number, or one each for x, y and z.</source>
        <translation>Die Maschine „%1“ hat kein %2: eine Zahl angeben, oder je eine für x, y und z.</translation>
    </message>
    <message>
        <source>The machine &apos;%1&apos; has the unknown key &apos;%2&apos;: its keys are %3.</source>
        <translation>Die Maschine „%1“ hat den unbekannten Schlüssel „%2“: ihre Schlüssel sind %3.</translation>
    </message>
    <message>
        <source>The margin must lie from 0 to below 1.</source>
        <translation>Der Abstand muss zwischen 0 und unter 1 liegen.</translation>
    </message>
    <message>
        <source>The margin of %1 mm leaves nothing of %2 of %3: take a smaller one.</source>
        <translation>Der Rand von %1 mm lässt von %2 von %3 nichts übrig: einen kleineren nehmen.</translation>
    </message>
    <message>
        <source>The material &apos;%1&apos; has no %2: give it one in N/mm2.</source>
        <translation>Der Werkstoff „%1“ hat kein %2: eines in N/mm2 angeben.</translation>
    </message>
    <message>
        <source>The material &apos;%1&apos; has the unknown key &apos;%2&apos;: its keys are %3.</source>
        <translation>Der Werkstoff „%1“ hat den unbekannten Schlüssel „%2“: seine Schlüssel sind %3.</translation>
    </message>
    <message>
        <source>The modes of &apos;%1&apos;</source>
        <translation>Die Moden von „%1“</translation>
    </message>
    <message>
        <source>The name of a file of points ends in .csv or %1, not as %2.</source>
        <translation>Der Name einer Punktdatei endet auf .csv oder %1, nicht auf %2.</translation>
    </message>
    <message>
        <source>The number of points is 1 to %1, not %2.</source>
        <translation>Die Anzahl der Punkte ist 1 bis %1, nicht %2.</translation>
    </message>
    <message>
        <source>The open edges %1 leave no clear room outside: they were taken for walls.</source>
        <translation>Die offenen Kanten %1 lassen außen keinen freien Raum: sie wurden als Wände genommen.</translation>
    </message>
    <message>
        <source>The operation has no base geometry: pick a face or a sketch for it.</source>
        <translation>Die Operation hat keine Basisgeometrie: eine Fläche oder Skizze dafür wählen.</translation>
    </message>
    <message>
        <source>The operation has no base geometry: pick the faces to be finished.</source>
        <translation>Die Operation hat keine Basisgeometrie: die zu schlichtenden Flächen wählen.</translation>
    </message>
    <message>
        <source>The operation has no tool: choose a tool controller for it.</source>
        <translation>Die Operation hat kein Werkzeug: eine Werkzeugsteuerung dafür wählen.</translation>
    </message>
    <message>
        <source>The outline</source>
        <translation>Der Umriss</translation>
    </message>
    <message>
        <source>The outline and an island cross or touch near (%1, %2): move them apart in the sketch, or join them into one curve.</source>
        <translation>Der Umriss und eine Insel kreuzen oder berühren sich bei (%1, %2): in der Skizze auseinander schieben, oder zu einer Kurve verbinden.</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself near (%1, %2): remove the crossing in the sketch.</source>
        <translation>Der Umriss kreuzt oder berührt sich selbst bei (%1, %2): die Kreuzung in der Skizze entfernen.</translation>
    </message>
    <message>
        <source>The outline is open at (%1, %2), the nearest other end is %3 mm away: close it.</source>
        <translation>Der Umriss ist offen bei (%1, %2), das nächste andere Ende ist %3 mm entfernt: schließen.</translation>
    </message>
    <message>
        <source>The path could not be computed.</source>
        <translation>Die Bahn konnte nicht berechnet werden.</translation>
    </message>
    <message>
        <source>The path cuts %1 mm into &apos;%2&apos; %3: change the depths, or what is picked.</source>
        <translation>Die Bahn schneidet %1 mm in „%2“ %3: die Tiefen ändern, oder was gewählt ist.</translation>
    </message>
    <message>
        <source>The path goes %1 mm below StartDepth, and the tool &apos;%2&apos; cuts over %3 mm of its length: see that its shank stays off the part.</source>
        <translation>Die Bahn geht %1 mm unter [StartDepth], und das Werkzeug „%2“ schneidet auf %3 mm seiner Länge: darauf achten, dass sein Schaft vom Teil wegbleibt.</translation>
    </message>
    <message>
        <source>The path has a rapid through %1 mm of material %2: raise StartDepth and SafeHeight above what stands there, or clear it before.</source>
        <translation>Die Bahn hat einen Eilgang durch %1 mm Material %2: [StartDepth] und [SafeHeight] über das erhöhen, was dort steht, oder es vorher ausräumen.</translation>
    </message>
    <message>
        <source>The path has more than %1 levels and the model leans: no part is taken.</source>
        <translation>Die Bahn hat mehr als %1 Ebenen und das Modell ist schräg: kein Teil wird genommen.</translation>
    </message>
    <message>
        <source>The path of &apos;%1&apos; cannot be checked: %2</source>
        <translation>Die Bahn von „%1“ kann nicht geprüft werden: %2</translation>
    </message>
    <message>
        <source>The path of &apos;%1&apos;, which comes before &apos;%2&apos;, is not up to date: recompute the document once more.</source>
        <translation>Die Bahn von „%1“, die vor „%2“ kommt, ist nicht aktuell: das Dokument noch einmal neu berechnen.</translation>
    </message>
    <message>
        <source>The path plunges into %1 mm of material %2: raise StartDepth above what stands there, clear it before, or choose another Entry.</source>
        <translation>Die Bahn taucht senkrecht in %1 mm Material %2: [StartDepth] über das erhöhen, was dort steht, es vorher ausräumen, oder [Entry] anders wählen.</translation>
    </message>
    <message>
        <source>The peak at %1 Hz is %2 lines wide: measure with a finer resolution.</source>
        <translation>Die Spitze bei %1 Hz ist %2 Linien breit: mit feinerer Auflösung messen.</translation>
    </message>
    <message>
        <source>The pocket %1 was skipped. The tool of %2 mm does not fit into the pocket: %3</source>
        <translation>Die Tasche %1 wurde ausgelassen. Das Werkzeug von %2 mm passt nicht hinein: %3</translation>
    </message>
    <message>
        <source>The point %1 is told twice: leave one out.</source>
        <translation>Der Punkt %1 kommt zweimal vor: einen weglassen.</translation>
    </message>
    <message>
        <source>The points are too few: this feature needs %1 at least.</source>
        <translation>Die Punkte sind zu wenige: mindestens %1 sind nötig.</translation>
    </message>
    <message>
        <source>The points fit the faces only if their numbers are %1: correct the unit that the file states.</source>
        <translation>Die Punkte passen nur zu den Flächen, wenn ihre Zahlen %1 sind: die Einheit der Datei berichtigen.</translation>
    </message>
    <message>
        <source>The points lie up to %1 mm from the part: align them with it first.</source>
        <translation>Die Punkte liegen bis zu %1 mm vom Teil entfernt: sie zuerst daran ausrichten.</translation>
    </message>
    <message>
        <source>The post-processor &apos;%1&apos; failed (%2): choose another, or mend it.</source>
        <translation>Der Postprozessor „%1“ ist gescheitert (%2): einen anderen wählen oder ihn reparieren.</translation>
    </message>
    <message>
        <source>The post-processor &apos;%1&apos; refuses the arguments &apos;%2&apos;.</source>
        <translation>Der Postprozessor „%1“ verweigert die Argumente „%2“.</translation>
    </message>
    <message>
        <source>The pre-drilled hole %1 is too near to a wall to come down in: it was not used.</source>
        <translation>Das vorgebohrte Loch %1 liegt zu nah an einer Wand, um darin einzutauchen: es wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>The pre-drilled hole %1 lies in a narrow passage that is skipped: it was not used.</source>
        <translation>Das vorgebohrte Loch %1 liegt in einer Engstelle, die ausgelassen wird: es wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>The pre-drilled hole is too tight to start from: drill it wider, or choose the entry &apos;Automatic&apos; or &apos;Helix&apos;.</source>
        <translation>Das vorgebohrte Loch ist zu eng, um darin zu beginnen: weiter bohren, oder das Eintauchen „Automatisch“ oder „Helix“ wählen.</translation>
    </message>
    <message>
        <source>The pre-drilled hole is too tight to start from: it was not used.</source>
        <translation>Das vorgebohrte Loch ist zu eng, um darin zu beginnen: es wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>The pre-drilled hole lies in a narrow passage that is skipped: choose the entry &apos;Automatic&apos;, or another NarrowPassages.</source>
        <translation>Das vorgebohrte Loch liegt in einer Engstelle, die ausgelassen wird: das Eintauchen „Automatisch“ wählen, oder [NarrowPassages] anders.</translation>
    </message>
    <message>
        <source>The pre-drilled hole was not used: a spiral around an island begins beside its wall.</source>
        <translation>Das vorgebohrte Loch wurde nicht benutzt: eine Spirale um eine Insel beginnt neben deren Wand.</translation>
    </message>
    <message>
        <source>The pre-drilled hole was not used: a spiral around an island in open stock comes from outside.</source>
        <translation>Das vorgebohrte Loch wurde nicht benutzt: eine Spirale um eine Insel in offenem Rohteil kommt von außen.</translation>
    </message>
    <message>
        <source>The pre-drilled hole&apos;s centre lies outside the ground that the tool can reach: move EntryPoint into the pocket, at least a tool&apos;s radius from its walls.</source>
        <translation>Die Mitte des vorgebohrten Lochs liegt außerhalb des Grunds, den das Werkzeug erreicht: [EntryPoint] in die Tasche verschieben, mindestens einen Werkzeugradius von ihren Wänden.</translation>
    </message>
    <message>
        <source>The program has several spindle speeds: the lowest, %1 rev/min, was taken.</source>
        <translation>Das Programm hat mehrere Spindeldrehzahlen: die niedrigste, %1 U/min, wurde genommen.</translation>
    </message>
    <message>
        <source>The region %1 does not hold the pre-drilled hole: it has an entry of its own.</source>
        <translation>Der Bereich %1 enthält das vorgebohrte Loch nicht: er hat sein eigenes Eintauchen.</translation>
    </message>
    <message>
        <source>The region %1, which does not hold the pre-drilled hole, was left uncut: choose the entry &apos;Automatic&apos;, or drill it and use an operation of its own.</source>
        <translation>Der Bereich %1, in dem das vorgebohrte Loch nicht liegt, blieb stehen: das Eintauchen „Automatisch“ wählen, oder dort bohren und eine eigene Operation verwenden.</translation>
    </message>
    <message>
        <source>The report is written.</source>
        <translation>Der Bericht ist geschrieben.</translation>
    </message>
    <message>
        <source>The resolution is coarser than the stock is wide: choose a finer one.</source>
        <translation>Die Auflösung ist gröber, als das Rohteil breit ist: eine feinere wählen.</translation>
    </message>
    <message>
        <source>The response has a gap between %1 and %2 Hz: measure it again, or cut it there.</source>
        <translation>Der Frequenzgang hat eine Lücke zwischen %1 und %2 Hz: noch einmal messen oder dort abschneiden.</translation>
    </message>
    <message>
        <source>The response has a value that is no number.</source>
        <translation>Der Frequenzgang hat einen Wert, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>The response has too few lines to look between them.</source>
        <translation>Der Frequenzgang hat zu wenige Linien, um dazwischen zu sehen.</translation>
    </message>
    <message>
        <source>The response has too few lines: at least four are needed.</source>
        <translation>Der Frequenzgang hat zu wenige Linien: mindestens vier sind nötig.</translation>
    </message>
    <message>
        <source>The response needs one value for each frequency.</source>
        <translation>Der Frequenzgang braucht einen Wert für jede Frequenz.</translation>
    </message>
    <message>
        <source>The response needs values of at least one axis, xx or yy.</source>
        <translation>Der Frequenzgang braucht Werte mindestens einer Achse, xx oder yy.</translation>
    </message>
    <message>
        <source>The retract height must be at least %1 mm, above every approach.</source>
        <translation>Die Rückzugshöhe muss mindestens %1 mm sein, über jeder Anfahrt.</translation>
    </message>
    <message>
        <source>The same of the exponent; evenly or late, as is quicker, where it is empty</source>
        <translation>Dasselbe für den Exponenten; leer: gleichmäßig oder spät, was schneller ist</translation>
    </message>
    <message>
        <source>The same of the second semi-axis</source>
        <translation>Dasselbe für die zweite Halbachse</translation>
    </message>
    <message>
        <source>The shape has no face.</source>
        <translation>Die Form hat keine Fläche.</translation>
    </message>
    <message>
        <source>The shape is no readable BREP text.</source>
        <translation>Die Form ist kein lesbarer BREP-Text.</translation>
    </message>
    <message>
        <source>The side step as a share of the diameter</source>
        <translation>Die Seitenzustellung als Anteil des Durchmessers</translation>
    </message>
    <message>
        <source>The simulation was cancelled.</source>
        <translation>Die Simulation wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The slot %1 is so little wider than the tool that posts would write the turns of constant engagement as lines with corners: circles are repeated there.</source>
        <translation>Die Nut %1 ist so wenig breiter als das Werkzeug, dass Postprozessoren die Windungen konstanten Eingriffs als Geraden mit Ecken schreiben würden: dort werden Kreise wiederholt.</translation>
    </message>
    <message>
        <source>The slot&apos;s sides meet each other: make the slot narrower, or move the parts of its middle further apart.</source>
        <translation>Die Seiten der Nut treffen sich: die Nut schmaler machen, oder die Teile ihrer Mitte weiter auseinander rücken.</translation>
    </message>
    <message>
        <source>The slot&apos;s width must be positive: set SlotWidth.</source>
        <translation>Die Nutbreite muss positiv sein: [SlotWidth] setzen.</translation>
    </message>
    <message>
        <source>The spindle can do none of the chart&apos;s speeds.</source>
        <translation>Die Spindel kann keine der Drehzahlen des Diagramms.</translation>
    </message>
    <message>
        <source>The spindle of &apos;%1&apos; does not turn: set its SpindleDir.</source>
        <translation>Die Spindel von „%1“ dreht nicht: [SpindleDir] setzen.</translation>
    </message>
    <message>
        <source>The spindle of &apos;%1&apos; turns counter-clockwise, as its SpindleDir says: the path goes the other way round, so that it cuts as %2.</source>
        <translation>Die Spindel von „%1“ dreht gegen den Uhrzeigersinn, wie ihr [SpindleDir] sagt: die Bahn läuft anders herum, so dass sie im %2 schneidet.</translation>
    </message>
    <message>
        <source>The spindle turns counter-clockwise: it is simulated as if clockwise.</source>
        <translation>Die Spindel dreht gegen den Uhrzeigersinn: sie wird wie im Uhrzeigersinn simuliert.</translation>
    </message>
    <message>
        <source>The spiral clears only %1 % of this pocket%2.</source>
        <translation>Die Spirale räumt nur %1 % dieser Tasche aus%2.</translation>
    </message>
    <message>
        <source>The spiral turns more tightly than MinimumRadius, down to %1 mm: raise ExponentStart or ExponentEnd, or make the courses more even.</source>
        <translation>Die Spirale dreht enger als [MinimumRadius], bis hinab zu %1 mm: [ExponentStart] oder [ExponentEnd] erhöhen, oder die Verläufe gleichmäßiger machen.</translation>
    </message>
    <message>
        <source>The spiral would take more than 2000 turns: raise EngagementAngle or Pitch, make courses more even, or take the operation Adaptive.</source>
        <translation>Die Spirale bräuchte mehr als 2000 Windungen: [EngagementAngle] oder [Pitch] erhöhen, Verläufe gleichmäßiger machen, oder die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>The stiffness of a mode must be above 0 N/um.</source>
        <translation>Die Steifigkeit einer Mode muss über 0 N/um liegen.</translation>
    </message>
    <message>
        <source>The stock &apos;%1&apos; cannot be read: %2.</source>
        <translation>Das Rohteil „%1“ kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>The stock &apos;%1&apos; is empty: give the job another one.</source>
        <translation>Das Rohteil „%1“ ist leer: dem Auftrag ein anderes geben.</translation>
    </message>
    <message>
        <source>The stock does not contain the part: %1 mm2 of it lie outside; enlarge the stock.</source>
        <translation>Das Rohteil enthält das Teil nicht: %1 mm2 davon liegen außerhalb; das Rohteil vergrößern.</translation>
    </message>
    <message>
        <source>The stock would need too many dexels: choose a coarser resolution.</source>
        <translation>Das Rohteil bräuchte zu viele Dexel: eine gröbere Auflösung wählen.</translation>
    </message>
    <message>
        <source>The stock&apos;s top must lie above its bottom.</source>
        <translation>Die Oberseite des Rohteils muss über seiner Unterseite liegen.</translation>
    </message>
    <message>
        <source>The text of the modes is no JSON: %1.</source>
        <translation>Der Text der Moden ist kein JSON: %1.</translation>
    </message>
    <message>
        <source>The tolerance must be above 0 mm.</source>
        <translation>Die Toleranz muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not cut at its centre and cannot enter by a ramp near (%2, %3): set a pre-drilled hole, or take a tool that cuts at its centre.</source>
        <translation>Das Werkzeug „%1“ schneidet nicht über Mitte und kann nicht entlang einer Rampe eintauchen bei (%2, %3): ein vorgebohrtes Loch setzen, oder ein über Mitte schneidendes Werkzeug nehmen.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not say its %2: stability is that of %3.</source>
        <translation>Das Werkzeug „%1“ nennt nicht: %2; die Stabilität gilt für %3.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not say its %2: the force is that of %3.</source>
        <translation>Das Werkzeug „%1“ nennt nicht: %2; die Kraft gilt für %3.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; is %2: choose %3 end mill.</source>
        <translation>Das Werkzeug „%1“ ist %2: einen Fräser wählen, %3.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; is simulated with sharp corners.</source>
        <translation>Das Werkzeug „%1“ wird mit scharfen Ecken simuliert.</translation>
    </message>
    <message>
        <source>The tool controller &apos;%1&apos; has no modes: give them, or load a tap test in the window Stability chart.</source>
        <translation>Die Werkzeugsteuerung „%1“ hat keine Moden: sie angeben, oder im Fenster Stabilitätskarte einen Klopftest laden.</translation>
    </message>
    <message>
        <source>The tool controller &apos;%1&apos; has no tool: choose one for it.</source>
        <translation>Die Werkzeugsteuerung „%1“ hat kein Werkzeug: eines dafür wählen.</translation>
    </message>
    <message>
        <source>The tool controller has no spindle speed: there is no chip thickness.</source>
        <translation>Die Werkzeugsteuerung hat keine Spindeldrehzahl: es gibt keine Spandicke.</translation>
    </message>
    <message>
        <source>The tool has no room to descend in this pocket: drill a hole first and choose the entry &apos;Predrilled hole&apos;, or take a smaller tool.</source>
        <translation>Das Werkzeug hat in dieser Tasche keinen Raum zum Eintauchen: zuerst ein Loch bohren und das Eintauchen „Vorgebohrtes Loch“ wählen, oder ein kleineres Werkzeug nehmen.</translation>
    </message>
    <message>
        <source>The triangles of &apos;%1&apos; leave it by %2 mm, too much for the Tolerance of %3 mm: raise it.</source>
        <translation>Die Dreiecke von „%1“ weichen um %2 mm ab, zu viel für [Tolerance] von %3 mm: erhöhen.</translation>
    </message>
    <message>
        <source>The trochoid&apos;s shape; the circular and the cycloid one reach the engagement angle only for a moment of each turn</source>
        <translation>Die Form der Trochoide; die kreisförmige und die zykloidische erreichen den Eingriffswinkel nur für einen Moment jeder Windung</translation>
    </message>
    <message>
        <source>The unit of %1 is unknown: name it, as unit=&apos;m/N&apos;; there are %2.</source>
        <translation>Die Einheit von %1 ist unbekannt: sie nennen, etwa unit=&apos;m/N&apos;; es gibt %2.</translation>
    </message>
    <message>
        <source>The work plane &apos;%1&apos; is turned, and EvenLoad cuts along the job&apos;s own axes: choose another, or turn the model in a job of its own.</source>
        <translation>Die Arbeitsebene „%1“ ist gedreht, und EvenLoad schneidet entlang der Achsen des Auftrags: eine andere wählen, oder das Modell in einem eigenen Auftrag drehen.</translation>
    </message>
    <message>
        <source>There is neither a face nor an edge to work on: pick a face or a sketch.</source>
        <translation>Es gibt weder eine Fläche noch eine Kante zu bearbeiten: eine Fläche oder Skizze wählen.</translation>
    </message>
    <message>
        <source>There is no %1 on %2: pick the faces anew.</source>
        <translation>Es gibt kein %1 an %2: die Flächen neu wählen.</translation>
    </message>
    <message>
        <source>There is no %1 on %2: pick the geometry anew.</source>
        <translation>Es gibt kein %1 an %2: die Geometrie neu wählen.</translation>
    </message>
    <message>
        <source>There is no machine &apos;%1&apos;: choose one of %2, or give a JSON file or a dictionary of limits.</source>
        <translation>Es gibt keine Maschine „%1“: eine von %2 wählen, oder eine JSON-Datei oder ein Wörterbuch von Grenzen angeben.</translation>
    </message>
    <message>
        <source>There is no material &apos;%1&apos;: choose one of %2, or give a JSON file or a dictionary with ktc and krc.</source>
        <translation>Es gibt keinen Werkstoff „%1“: einen von %2 wählen, oder eine JSON-Datei oder ein Wörterbuch mit ktc und krc angeben.</translation>
    </message>
    <message>
        <source>There is no post-processor &apos;%1&apos;: this FreeCAD has %2.</source>
        <translation>Es gibt keinen Postprozessor „%1“: dieses FreeCAD hat %2.</translation>
    </message>
    <message>
        <source>This FreeCAD has %1, EvenLoad&apos;s compiled modules are for %2: %3</source>
        <translation>Dieses FreeCAD hat %1, die kompilierten Module von EvenLoad sind für %2: %3</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time %s</source>
        <translation>Zeit %s</translation>
    </message>
    <message>
        <source>Times are within its limits</source>
        <translation>Zeiten gelten innerhalb ihrer Grenzen</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tool centre</source>
        <translation>Werkzeugmitte</translation>
    </message>
    <message>
        <source>Tool contact</source>
        <translation>Berührpunkt</translation>
    </message>
    <message>
        <source>Tool controller</source>
        <translation>Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Trochoid with smaller radius</source>
        <translation>Trochoide, kleinerer Radius</translation>
    </message>
    <message>
        <source>Turned more tightly than the wished %1 mm in %2, down to %3 mm %4.</source>
        <translation>Enger gedreht als die gewünschten %1 mm: %2, bis hinab zu %3 mm %4.</translation>
    </message>
    <message>
        <source>Two islands cross or touch near (%1, %2): move them apart in the sketch, or join them into one curve.</source>
        <translation>Zwei Inseln kreuzen oder berühren sich bei (%1, %2): in der Skizze auseinander schieben, oder zu einer Kurve verbinden.</translation>
    </message>
    <message>
        <source>Two outlines cross or touch: keep them apart, or draw what they enclose together as one.</source>
        <translation>Zwei Umrisse kreuzen oder berühren sich: getrennt halten, oder was sie zusammen umschließen als eines zeichnen.</translation>
    </message>
    <message>
        <source>Uncut %s</source>
        <translation>Rest %s</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>Valid, checked against the model</source>
        <translation>Gültig, gegen das Modell geprüft</translation>
    </message>
    <message>
        <source>Vert. Feed</source>
        <translation>Vertik. Vorschub</translation>
    </message>
    <message>
        <source>Vibration at the tool&apos;s tip</source>
        <translation>Schwingung an der Werkzeugspitze</translation>
    </message>
    <message>
        <source>Wall pass</source>
        <translation>Durchgang an der Wand</translation>
    </message>
    <message>
        <source>What earlier operations left in narrow passages is cut by trochoids, not at a reduced feed.</source>
        <translation>Was frühere Operationen in Engstellen übrig ließen, wird durch Trochoiden geschnitten, nicht mit weniger Vorschub.</translation>
    </message>
    <message>
        <source>What has to lie on the picked faces while the tool cuts: the point where it touches, or its axis seen from above</source>
        <translation>Was auf den gewählten Flächen liegen muss, während das Werkzeug schneidet: sein Berührpunkt, oder seine Achse von oben gesehen</translation>
    </message>
    <message>
        <source>What is cut; only Constant force asks for it</source>
        <translation>Was geschnitten wird; nur die konstante Kraft fragt danach</translation>
    </message>
    <message>
        <source>What is done where the width left for the tool&apos;s centre is under twice MinimumRadius</source>
        <translation>Was geschieht, wo die Breite für die Werkzeugmitte unter dem Doppelten des kleinsten Radius liegt</translation>
    </message>
    <message>
        <source>What must stay of the model is not known: %1.</source>
        <translation>Was vom Modell stehen bleiben muss, ist nicht bekannt: %1.</translation>
    </message>
    <message>
        <source>What stands above %1 mm could not be found (%2)</source>
        <translation>Was über %1 mm steht, konnte nicht gefunden werden (%2)</translation>
    </message>
    <message>
        <source>What stays above FinalDepth</source>
        <translation>Was über der Endtiefe stehen bleibt</translation>
    </message>
    <message>
        <source>What stays at the walls</source>
        <translation>Was an den Wänden stehen bleibt</translation>
    </message>
    <message>
        <source>What stays on the whole part, measured across its surface</source>
        <translation>Was auf dem ganzen Teil stehen bleibt, quer zur Fläche gemessen</translation>
    </message>
    <message>
        <source>What stays the same where the engagement is below its target</source>
        <translation>Was gleich bleibt, wo der Eingriff unter seinem Ziel liegt</translation>
    </message>
    <message>
        <source>What the spiral does not reach: cleared at constant engagement, or left</source>
        <translation>Was die Spirale nicht erreicht: mit konstantem Eingriff ausgeräumt oder stehen gelassen</translation>
    </message>
    <message>
        <source>What was set shall follow the geometry again</source>
        <translation>Was gesetzt wurde, soll wieder der Geometrie folgen</translation>
    </message>
    <message>
        <source>Where the feed control would change the feed so often that a program has more blocks per metre of path, it changes it less often, for up to 4 % more time, but not along repeated trochoids or with a least load: for controllers that take few blocks; 0: no limit</source>
        <translation>Wo die Regelung den Vorschub so oft ändern würde, dass ein Programm mehr Sätze je Meter Bahn hätte, ändert sie ihn seltener, für bis zu 4 % mehr Zeit, doch nicht an wiederholten Trochoiden oder mit einer kleinsten Last: für Steuerungen, die wenige Sätze verarbeiten; 0: keine Grenze</translation>
    </message>
    <message>
        <source>Where to measure</source>
        <translation>Messstellen</translation>
    </message>
    <message>
        <source>Wherever the feed is below MaximumFeed, what the feed control holds is at least this share of its nominal value, as far as moves can be divided: less time, more blocks; 0 to 0.95</source>
        <translation>Wo der Vorschub unter dem größten liegt, beträgt das Geregelte mindestens diesen Anteil seines Nennwerts, soweit sich Bewegungen teilen lassen: weniger Zeit, mehr Sätze; 0 bis 0.95</translation>
    </message>
    <message>
        <source>Whether the cut is stable is not known: %1</source>
        <translation>Ob der Schnitt stabil ist, ist nicht bekannt: %1</translation>
    </message>
    <message>
        <source>Which way the cutting edges meet the material, whichever way the spindle turns</source>
        <translation>Wie die Schneiden auf das Material treffen, gleich wie sich die Spindel dreht</translation>
    </message>
    <message>
        <source>Whole Time</source>
        <translation>Ganze Zeit</translation>
    </message>
    <message>
        <source>Whose path is simulated</source>
        <translation>Deren Bahn simuliert wird</translation>
    </message>
    <message>
        <source>Width of the slot round a sketch or edges, which are its centreline once this is set; faces have their own</source>
        <translation>Breite der Nut um eine Skizze oder Kanten, die dann deren Mittellinie sind; Flächen haben ihre eigene</translation>
    </message>
    <message>
        <source>Width of the zone that is allowed</source>
        <translation>Breite der erlaubten Zone</translation>
    </message>
    <message>
        <source>Wished radius of roll-in and roll-out; at first 0.15 of the tool&apos;s diameter</source>
        <translation>Gewünschter Radius des Ein- und Ausrollens; zunächst das 0.15-Fache des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>Wished smallest radius of the path; at first 0.15 of the tool&apos;s diameter</source>
        <translation>Gewünschter kleinster Radius der Bahn; zunächst das 0.15-Fache des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>Writes G-code that probes these points, G38.2, by the post-processor</source>
        <translation>Schreibt G-Code, der diese Punkte antastet, G38.2, über den Postprozessor</translation>
    </message>
    <message>
        <source>Writes a report to print, HTML</source>
        <translation>Schreibt einen druckbaren Bericht, HTML</translation>
    </message>
    <message>
        <source>Writes all samples, CSV</source>
        <translation>Schreibt alle Messwerte, CSV</translation>
    </message>
    <message>
        <source>Writes the modes to a file, for other tools and jobs</source>
        <translation>Schreibt die Moden in eine Datei, für andere Werkzeuge und Aufträge</translation>
    </message>
    <message>
        <source>Writes these points as CSV or DMIS</source>
        <translation>Schreibt diese Punkte als CSV oder DMIS</translation>
    </message>
    <message>
        <source>Zig-zag</source>
        <translation>Zickzack</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>a V bit</source>
        <translation>ein V-Stichel</translation>
    </message>
    <message>
        <source>a ball end mill</source>
        <translation>ein Kugelfräser</translation>
    </message>
    <message>
        <source>a ball end, bull-nosed or flat</source>
        <translation>mit Kugelende, mit Eckenradius oder flach</translation>
    </message>
    <message>
        <source>a chamfering tool</source>
        <translation>ein Fasfräser</translation>
    </message>
    <message>
        <source>a corner-rounding tool</source>
        <translation>ein Viertelkreisfräser</translation>
    </message>
    <message>
        <source>a dovetail cutter</source>
        <translation>ein Schwalbenschwanzfräser</translation>
    </message>
    <message>
        <source>a drill</source>
        <translation>ein Bohrer</translation>
    </message>
    <message>
        <source>a flat or bull-nosed</source>
        <translation>flach oder mit Eckenradius</translation>
    </message>
    <message>
        <source>a helix of %1 degrees</source>
        <translation>einem Drall von %1 Grad</translation>
    </message>
    <message>
        <source>a probe</source>
        <translation>ein Taster</translation>
    </message>
    <message>
        <source>a reamer</source>
        <translation>eine Reibahle</translation>
    </message>
    <message>
        <source>a slitting saw</source>
        <translation>ein Sägeblatt</translation>
    </message>
    <message>
        <source>a tap</source>
        <translation>ein Gewindebohrer</translation>
    </message>
    <message>
        <source>a tapered ball end mill</source>
        <translation>ein konischer Kugelfräser</translation>
    </message>
    <message>
        <source>a thread mill</source>
        <translation>ein Gewindefräser</translation>
    </message>
    <message>
        <source>all lines</source>
        <translation>alle Linien</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>entlang X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>entlang Y</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>as is quicker</source>
        <translation>was schneller ist</translation>
    </message>
    <message>
        <source>build EvenLoad for it with &apos;./run install&apos; in its source tree (README.md).</source>
        <translation>EvenLoad dafür mit „./run install“ in seinem Quellbaum bauen (README.md).</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>constant engagement</source>
        <translation>konstanter Eingriff</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>cut above %s</source>
        <translation>Schnitt über %s</translation>
    </message>
    <message>
        <source>cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>cylindricity</source>
        <translation>Zylindrizität</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>drills from Z%1 up to Z%2: correct its R.</source>
        <translation>bohrt von Z%1 hinauf nach Z%2: R berichtigen.</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>evenly</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>flatness</source>
        <translation>Ebenheit</translation>
    </message>
    <message>
        <source>from the face</source>
        <translation>wie Fläche</translation>
    </message>
    <message>
        <source>has a number that is not finite: compute the operation anew.</source>
        <translation>hat eine Zahl, die nicht endlich ist: die Operation neu berechnen.</translation>
    </message>
    <message>
        <source>has a second G word, which is lost: give that a line of its own.</source>
        <translation>hat ein zweites G-Wort, das verloren geht: ihm eine eigene Zeile geben.</translation>
    </message>
    <message>
        <source>has no depth of peck: give it Q.</source>
        <translation>hat keine Spantiefe: Q angeben.</translation>
    </message>
    <message>
        <source>has no radius: give it I and J.</source>
        <translation>hat keinen Radius: I und J angeben.</translation>
    </message>
    <message>
        <source>helix angle</source>
        <translation>Drallwinkel</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>in tolerance</source>
        <translation>in Toleranz</translation>
    </message>
    <message>
        <source>is an arc whose radii at its ends are %1 and %2 mm: correct its I and J.</source>
        <translation>ist ein Bogen mit den Radien %1 und %2 mm an seinen Enden: I und J berichtigen.</translation>
    </message>
    <message>
        <source>is no G-code: leave it out.</source>
        <translation>ist kein G-Code: weglassen.</translation>
    </message>
    <message>
        <source>is not known to the simulator: leave it out.</source>
        <translation>ist dem Simulator nicht bekannt: weglassen.</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>lower the step down below %1 mm</source>
        <translation>die Zustelltiefe unter %1 mm senken</translation>
    </message>
    <message>
        <source>lower the step down below %1 mm or turn the spindle at %2 rev/min</source>
        <translation>die Zustelltiefe unter %1 mm senken oder die Spindel mit %2 U/min drehen</translation>
    </message>
    <message>
        <source>magnitude-phase</source>
        <translation>Betrag und Phase</translation>
    </message>
    <message>
        <source>must be positive</source>
        <translation>muss positiv sein</translation>
    </message>
    <message>
        <source>must lie between %1 and %2%3</source>
        <translation>muss zwischen %1 und %2%3 liegen</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>darf nicht negativ sein</translation>
    </message>
    <message>
        <source>narrow places</source>
        <translation>Engstellen</translation>
    </message>
    <message>
        <source>narrow places of %1 rooms</source>
        <translation>Engstellen von %1 Räumen</translation>
    </message>
    <message>
        <source>near (%1, %2)</source>
        <translation>bei (%1, %2)</translation>
    </message>
    <message>
        <source>near (%1, %2, %3)</source>
        <translation>bei (%1, %2, %3)</translation>
    </message>
    <message>
        <source>no end mill</source>
        <translation>kein Schaftfräser</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>no straight cylinder</source>
        <translation>kein gerader Zylinder</translation>
    </message>
    <message>
        <source>no tool does, lower StockToLeave.</source>
        <translation>keines passt, [StockToLeave] senken.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nicht entschieden</translation>
    </message>
    <message>
        <source>number of teeth</source>
        <translation>Zähnezahl</translation>
    </message>
    <message>
        <source>number of teeth and its helix angle</source>
        <translation>Zähnezahl und Drallwinkel</translation>
    </message>
    <message>
        <source>of the type %1</source>
        <translation>vom Typ %1</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>außerhalb der Toleranz</translation>
    </message>
    <message>
        <source>point beyond the tolerance</source>
        <translation>Punkt außerhalb der Toleranz</translation>
    </message>
    <message>
        <source>points of contact</source>
        <translation>Berührpunkte</translation>
    </message>
    <message>
        <source>profile of a surface</source>
        <translation>Profil einer Fläche</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>rapids</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>real-imaginary</source>
        <translation>Real- und Imaginärteil</translation>
    </message>
    <message>
        <source>rev/min</source>
        <translation>U/min</translation>
    </message>
    <message>
        <source>roundness</source>
        <translation>Rundheit</translation>
    </message>
    <message>
        <source>sphericity</source>
        <translation>Kugelform</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>straightness</source>
        <translation>Geradheit</translation>
    </message>
    <message>
        <source>that side</source>
        <translation>diese Seite</translation>
    </message>
    <message>
        <source>the largest tool that fits has %1 mm.</source>
        <translation>das größte passende Werkzeug hat %1 mm.</translation>
    </message>
    <message>
        <source>the user&apos;s machine</source>
        <translation>die eigene Maschine</translation>
    </message>
    <message>
        <source>the user&apos;s material</source>
        <translation>der eigene Werkstoff</translation>
    </message>
    <message>
        <source>the user&apos;s modes</source>
        <translation>die eigenen Moden</translation>
    </message>
    <message>
        <source>these sides</source>
        <translation>diese Seiten</translation>
    </message>
    <message>
        <source>turns the work: only paths with a fixed tool axis can be simulated.</source>
        <translation>dreht das Werkstück: nur Bahnen mit fester Werkzeugachse können simuliert werden.</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>vertikal</translation>
    </message>
    <message>
        <source>where earlier cuts left the material in pieces of any shape</source>
        <translation>wo frühere Schnitte das Material in Stücken beliebiger Form gelassen haben</translation>
    </message>
    <message>
        <source>where no ground for a first period could be cleared</source>
        <translation>wo kein Grund für eine erste Periode ausgeräumt werden konnte</translation>
    </message>
    <message>
        <source>where no walls stay equally far apart, straight or as arcs about one centre, for as long as the slot is wide</source>
        <translation>wo keine Wände, gerade oder als Bögen um eine Mitte, so lange gleich weit voneinander bleiben, wie die Nut breit ist</translation>
    </message>
    <message>
        <source>where the slot is too short for a few periods</source>
        <translation>wo die Nut für einige Perioden zu kurz ist</translation>
    </message>
    <message>
        <source>where the tool has too little room to turn in the slot</source>
        <translation>wo das Werkzeug in der Nut zu wenig Raum zum Drehen hat</translation>
    </message>
    <message>
        <source>where the walls are more than four tool diameters apart</source>
        <translation>wo die Wände mehr als vier Werkzeugdurchmesser auseinander liegen</translation>
    </message>
    <message>
        <source>without a diameter</source>
        <translation>ohne Durchmesser</translation>
    </message>
    <message>
        <source>○ as it is   ● as chosen</source>
        <translation>○ wie jetzt   ● wie gewählt</translation>
    </message>
    <message>
        <source>%s: error %.1f %%</source>
        <translation>%s: Fehler %.1f %%</translation>
    </message>
    <message>
        <source>The document &apos;%1&apos; has no 3D view: open one.</source>
        <translation>Das Dokument „%1“ hat keine 3D-Ansicht: eine öffnen.</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>imaginary part of %s, µm/N</source>
        <translation>Imaginärteil von %s, µm/N</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>no material, no force</source>
        <translation>kein Werkstoff, keine Kraft</translation>
    </message>
    <message>
        <source>real part of %s, µm/N</source>
        <translation>Realteil von %s, µm/N</translation>
    </message>
    <message>
        <source>spindle speed, rev/min</source>
        <translation>Spindeldrehzahl, U/min</translation>
    </message>
    <message>
        <source>time on the machine, s</source>
        <translation>Zeit auf der Maschine, s</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>A Lamé spiral cannot clear what earlier operations left: turn UseRestMachining off, or take the operation Adaptive.</source>
        <translation>Eine Lamé-Spirale kann nicht ausräumen, was frühere Operationen übrig ließen: [UseRestMachining] ausschalten, oder die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>The points all lie in one place: a line needs two places at least.</source>
        <translation>Alle Punkte liegen an einer Stelle: eine Gerade braucht mindestens zwei Stellen.</translation>
    </message>
    <message>
        <source>The points do not determine a cylinder: measure it at two heights and all around, or over as much of it as there is.</source>
        <translation>Die Punkte bestimmen keinen Zylinder: in zwei Höhen und rundum messen, oder so weit es geht.</translation>
    </message>
    <message>
        <source>The points lie in one plane or on one circle: a sphere needs points beside it.</source>
        <translation>Die Punkte liegen in einer Ebene oder auf einem Kreis: eine Kugel braucht Punkte daneben.</translation>
    </message>
    <message>
        <source>The points lie on one line, or in two places: a circle needs three places off a line.</source>
        <translation>Die Punkte liegen auf einer Geraden oder an zwei Stellen: ein Kreis braucht drei Stellen abseits einer Geraden.</translation>
    </message>
    <message>
        <source>The points lie on one line: a plane needs points beside it.</source>
        <translation>Die Punkte liegen auf einer Geraden: eine Ebene braucht Punkte daneben.</translation>
    </message>
    <message>
        <source>The resolution must be positive, in mm.</source>
        <translation>Die Auflösung muss positiv sein, in mm.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle bends more tightly than half the slot&apos;s width: make the slot narrower, or bend it less.</source>
        <translation>Die Nutmitte biegt enger als die halbe Nutbreite: die Nut schmaler machen, oder weniger biegen.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle crosses itself: divide it into slots that do not.</source>
        <translation>Die Nutmitte kreuzt sich selbst: in Nuten teilen, die das nicht tun.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle has no length: draw a line or an arc along the slot.</source>
        <translation>Die Nutmitte hat keine Länge: eine Linie oder einen Bogen entlang der Nut zeichnen.</translation>
    </message>
    <message>
        <source>The slot&apos;s middle must have finite coordinates.</source>
        <translation>Die Nutmitte muss endliche Koordinaten haben.</translation>
    </message>
    <message>
        <source>The stock has no region: give it one.</source>
        <translation>Das Rohteil hat keinen Bereich: ihm einen geben.</translation>
    </message>
    <message>
        <source>The stock has no upper side: give it one.</source>
        <translation>Das Rohteil hat keine Oberseite: ihm eine geben.</translation>
    </message>
    <message>
        <source>The stock&apos;s top and bottom must be numbers, in mm.</source>
        <translation>Ober- und Unterseite des Rohteils müssen Zahlen sein, in mm.</translation>
    </message>
    <message>
        <source>The region near (%1, %2): %3</source>
        <translation>Der Bereich bei (%1, %2): %3</translation>
    </message>
    <message>
        <source>%1 chatters %2 mm deep at %3 rev/min and %4°, where the feed is at %5° to X.</source>
        <translation>%1 rattert, %2 mm tief bei %3 U/min und %4°, wo der Vorschub in %5° zu X steht.</translation>
    </message>
    <message>
        <source>%1 mm is deeper than the cutting length of %2, %3 mm.</source>
        <translation>%1 mm ist tiefer als die Schneidenlänge von %2, %3 mm.</translation>
    </message>
    <message>
        <source>%1 nearly chatters %2 mm deep at %3 rev/min and %4°, where the feed is at %5° to X.</source>
        <translation>%1 rattert beinahe, %2 mm tief bei %3 U/min und %4°, wo der Vorschub in %5° zu X steht.</translation>
    </message>
    <message>
        <source>%1 of %2 places along the path are not counted: the tool is at an edge or border there, or takes no chip that is known.</source>
        <translation>%1 von %2 Stellen entlang der Bahn sind nicht gezählt: das Werkzeug steht dort an einer Kante oder am Rand, oder nimmt keinen bekannten Span.</translation>
    </message>
    <message>
        <source>%1 of the tool controller &apos;%2&apos; cannot be read: empty it.</source>
        <translation>%1 der Werkzeugsteuerung „%2“ kann nicht gelesen werden: leeren.</translation>
    </message>
    <message>
        <source>%1 rev/min is outside of what %2 and the machine can do, %3 to %4 rev/min.</source>
        <translation>%1 U/min liegt außerhalb dessen, was %2 und die Maschine können, %3 bis %4 U/min.</translation>
    </message>
    <message>
        <source>%s cuts by %s.</source>
        <translation>%s schneidet nach %s.</translation>
    </message>
    <message>
        <source>A click on the rim or the wall of a hole in the 3D view takes its centre and diameter, one elsewhere the place alone</source>
        <translation>Ein Klick auf Rand oder Wand eines Lochs in der 3D-Ansicht nimmt dessen Mitte und Durchmesser, einer daneben nur die Stelle</translation>
    </message>
    <message>
        <source>A flat end mill leaves steps, not cusps: set a stepover, or take a ball end mill.</source>
        <translation>Ein Schaftfräser lässt Stufen, keine Rillen: einen Bahnabstand setzen, oder einen Kugelfräser nehmen.</translation>
    </message>
    <message>
        <source>A guide has no length: pick another edge.</source>
        <translation>Eine Leitkurve hat keine Länge: eine andere Kante wählen.</translation>
    </message>
    <message>
        <source>A number for finishing is not finite.</source>
        <translation>Eine Zahl für das Schlichten ist nicht endlich.</translation>
    </message>
    <message>
        <source>A patch needs two curvatures in 1/mm, a slope from 0 to below 90 degrees and the direction in which it leans.</source>
        <translation>Ein Flächenstück braucht zwei Krümmungen in 1/mm, eine Neigung von 0 bis unter 90 Grad und die Richtung, in die es sich neigt.</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>All figures are at a constant feed, for a constant force does not scale.</source>
        <translation>Alle Zahlen gelten bei konstantem Vorschub, denn eine konstante Kraft lässt sich nicht umrechnen.</translation>
    </message>
    <message>
        <source>All figures are of whole floors, as if nothing had been cut before.</source>
        <translation>Alle Zahlen gelten für ganze Böden, als wäre vorher nichts geschnitten.</translation>
    </message>
    <message>
        <source>All figures are those of EvenLoad Adaptive on the same floors.</source>
        <translation>Alle Zahlen sind die von EvenLoad Adaptiv auf denselben Böden.</translation>
    </message>
    <message>
        <source>All figures are without the stock to leave at the walls.</source>
        <translation>Alle Zahlen sind ohne das Aufmaß an den Wänden.</translation>
    </message>
    <message>
        <source>Angle, °</source>
        <translation>Winkel, °</translation>
    </message>
    <message>
        <source>Angles are numbers between 0 and 180, as 45; 60; 75.</source>
        <translation>Winkel sind Zahlen zwischen 0 und 180, etwa 45; 60; 75.</translation>
    </message>
    <message>
        <source>Angles, °</source>
        <translation>Winkel in °</translation>
    </message>
    <message>
        <source>At its end</source>
        <translation>An seinem Ende</translation>
    </message>
    <message>
        <source>At the least chip of %1 mm %2 of the tool of %3 mm at %4°, %5 mm deep, is above %6.</source>
        <translation>Bei der kleinsten Spandicke von %1 mm liegt %2 über %6 (Werkzeug von %3 mm bei %4°, %5 mm tief).</translation>
    </message>
    <message>
        <source>Between guides</source>
        <translation>Zwischen Leitkurven</translation>
    </message>
    <message>
        <source>Blue to white</source>
        <translation>Blau bis Weiß</translation>
    </message>
    <message>
        <source>Chatter is not looked at: the tool has no modes of it.</source>
        <translation>Rattern wird nicht betrachtet: das Werkzeug hat keine Moden dafür.</translation>
    </message>
    <message>
        <source>Chip, %s</source>
        <translation>Spandicke, %s</translation>
    </message>
    <message>
        <source>Chosen…</source>
        <translation>Gewählte…</translation>
    </message>
    <message>
        <source>Colours of values</source>
        <translation>Farben der Werte</translation>
    </message>
    <message>
        <source>Concave</source>
        <translation>Konkav</translation>
    </message>
    <message>
        <source>Convex</source>
        <translation>Konvex</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Datum</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes</source>
        <translation>Abstand benachbarter Bahnen</translation>
    </message>
    <message>
        <source>Engagement angles in degrees</source>
        <translation>Eingriffswinkel in Grad</translation>
    </message>
    <message>
        <source>EvenLoad Finishing Advisor</source>
        <translation>EvenLoad Schlichtberater</translation>
    </message>
    <message>
        <source>EvenLoad Optimise</source>
        <translation>EvenLoad Optimieren</translation>
    </message>
    <message>
        <source>EvenLoad Optimise: %s</source>
        <translation>EvenLoad Optimieren: %s</translation>
    </message>
    <message>
        <source>Face radius</source>
        <translation>Flächenradius</translation>
    </message>
    <message>
        <source>Feed direction</source>
        <translation>Vorschubrichtung</translation>
    </message>
    <message>
        <source>Feed direction and Rz must be numbers, and Rz not below 0.</source>
        <translation>Vorschubrichtung und Rz müssen Zahlen sein, und Rz nicht unter 0.</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Vorschub je Zahn</translation>
    </message>
    <message>
        <source>Feed, %s/min</source>
        <translation>Vorschub, %s/min</translation>
    </message>
    <message>
        <source>Feeds must be positive.</source>
        <translation>Vorschübe müssen positiv sein.</translation>
    </message>
    <message>
        <source>Fewer paths are computed, which is quicker</source>
        <translation>Weniger Bahnen werden berechnet, das geht schneller</translation>
    </message>
    <message>
        <source>Finds the quickest cut that keeps these limits</source>
        <translation>Findet den schnellsten Schnitt, der diese Grenzen einhält</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Schlichten</translation>
    </message>
    <message>
        <source>Free motions</source>
        <translation>Freie Bewegungen</translation>
    </message>
    <message>
        <source>From the least value to the largest</source>
        <translation>Vom kleinsten Wert zum größten</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Gives the operation the chosen strategy</source>
        <translation>Gibt der Operation die gewählte Strategie</translation>
    </message>
    <message>
        <source>Height of what stands between two passes</source>
        <translation>Höhe dessen, was zwischen zwei Bahnen stehen bleibt</translation>
    </message>
    <message>
        <source>Highest cusp</source>
        <translation>Höchste Rille</translation>
    </message>
    <message>
        <source>How it is bent</source>
        <translation>Wie sie gekrümmt ist</translation>
    </message>
    <message>
        <source>How many cutting edges it has around</source>
        <translation>Wie viele Schneiden es am Umfang hat</translation>
    </message>
    <message>
        <source>How many numbers of levels, from the fewest possible on</source>
        <translation>Wie viele Anzahlen von Ebenen, ab der kleinstmöglichen</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>In the window; the setup sheet of a job comes first. Macros and job files begin with the same values for everyone</source>
        <translation>Im Fenster; das Setup-Blatt eines Auftrags geht vor. Makros und Auftragsdateien beginnen bei allen mit denselben Werten</translation>
    </message>
    <message>
        <source>It exceeds the tolerance of %1.</source>
        <translation>Die Toleranz von %1 ist überschritten.</translation>
    </message>
    <message>
        <source>It keeps the tolerance of %1.</source>
        <translation>Die Toleranz von %1 ist eingehalten.</translation>
    </message>
    <message>
        <source>Its times, largest feed and spindle</source>
        <translation>Ihre Zeiten, ihr größter Vorschub und ihre Spindel</translation>
    </message>
    <message>
        <source>Its tool must have a ball end</source>
        <translation>Ihr Werkzeug muss ein Kugelende haben</translation>
    </message>
    <message>
        <source>Keep the angle</source>
        <translation>Winkel beibehalten</translation>
    </message>
    <message>
        <source>Keep the step down</source>
        <translation>Zustelltiefe beibehalten</translation>
    </message>
    <message>
        <source>Largest cutting force that tool and clamping stand</source>
        <translation>Größte Schnittkraft, die Werkzeug und Spannung aushalten</translation>
    </message>
    <message>
        <source>Largest power; the machine&apos;s own holds besides</source>
        <translation>Größte Leistung; die der Maschine gilt außerdem</translation>
    </message>
    <message>
        <source>Largest torque; the machine&apos;s own holds besides</source>
        <translation>Größtes Drehmoment; das der Maschine gilt außerdem</translation>
    </message>
    <message>
        <source>Lead radius</source>
        <translation>Ein-/Ausfahrradius</translation>
    </message>
    <message>
        <source>Least speed</source>
        <translation>Kleinstes Tempo</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Limits of a tool</source>
        <translation>Grenzen eines Werkzeugs</translation>
    </message>
    <message>
        <source>Make Operation</source>
        <translation>Operation erstellen</translation>
    </message>
    <message>
        <source>Makes an operation EvenLoad Finishing of the chosen strategy</source>
        <translation>Erstellt eine Operation EvenLoad Schlichten mit der gewählten Strategie</translation>
    </message>
    <message>
        <source>Mean cusp</source>
        <translation>Mittlere Rille</translation>
    </message>
    <message>
        <source>Mean thickness</source>
        <translation>Mittlere Dicke</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Measured; an operation tells the height of its cusps, the least that it can be</source>
        <translation>Gemessen; eine Operation nennt die Höhe ihrer Rillen, das Kleinste, was möglich ist</translation>
    </message>
    <message>
        <source>New operations begin with</source>
        <translation>Neue Operationen beginnen mit</translation>
    </message>
    <message>
        <source>No candidate is within the limits: %1 refuses most, %2 of %3, as in: %4</source>
        <translation>Kein Kandidat hält die Grenzen ein: %1 verhindert die meisten, %2 von %3, etwa so: %4</translation>
    </message>
    <message>
        <source>No chip: earlier passes left no stock where the tool stands.</source>
        <translation>Kein Span: frühere Bahnen ließen kein Aufmaß, wo das Werkzeug steht.</translation>
    </message>
    <message>
        <source>No level is deeper</source>
        <translation>Keine Ebene ist tiefer</translation>
    </message>
    <message>
        <source>None of the faces is a cylinder: the prediction is for the one that is told here.</source>
        <translation>Keine der Flächen ist ein Zylinder: die Vorhersage gilt für den hier angegebenen.</translation>
    </message>
    <message>
        <source>None, as aligned</source>
        <translation>Keine, wie ausgerichtet</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Numbers of levels</source>
        <translation>Anzahlen von Ebenen</translation>
    </message>
    <message>
        <source>Of a level face; sets the stepover</source>
        <translation>Einer ebenen Fläche; setzt den Bahnabstand</translation>
    </message>
    <message>
        <source>Of an operation, or of your own</source>
        <translation>Einer Operation, oder eigene</translation>
    </message>
    <message>
        <source>Of neighbouring passes, seen from above</source>
        <translation>Benachbarter Bahnen, von oben gesehen</translation>
    </message>
    <message>
        <source>Of the chips: mean of h_m on the way</source>
        <translation>Der Späne: Mittel von h_m auf dem Weg</translation>
    </message>
    <message>
        <source>Of the cutting force over the time of the cuts</source>
        <translation>Der Schnittkraft über die Zeit der Schnitte</translation>
    </message>
    <message>
        <source>Of the cylinder</source>
        <translation>Des Zylinders</translation>
    </message>
    <message>
        <source>Of the passes, seen from above, to the cylinder&apos;s axis</source>
        <translation>Der Bahnen, von oben gesehen, zur Zylinderachse</translation>
    </message>
    <message>
        <source>Of the path at its own feeds</source>
        <translation>Der Bahn mit ihren eigenen Vorschüben</translation>
    </message>
    <message>
        <source>Of the tool</source>
        <translation>Des Werkzeugs</translation>
    </message>
    <message>
        <source>Outside of what the source measured, a guess: %1.</source>
        <translation>Außerhalb dessen, was die Quelle gemessen hat, eine Schätzung: %1.</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Passes between guides need two of them beside the faces: pick two edges, or two chains.</source>
        <translation>Bahnen zwischen Leitkurven brauchen zwei davon neben den Flächen: zwei Kanten wählen, oder zwei Ketten.</translation>
    </message>
    <message>
        <source>Passes between guides need two of them beside the faces: pick two edges, or two chains. What is picked makes %1 lines.</source>
        <translation>Bahnen zwischen Leitkurven brauchen zwei davon neben den Flächen: zwei Kanten wählen, oder zwei Ketten. Das Gewählte ergibt %1 Linien.</translation>
    </message>
    <message>
        <source>Passes between guides need two of them.</source>
        <translation>Bahnen zwischen Leitkurven brauchen zwei davon.</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Pick the Hole</source>
        <translation>Loch wählen</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Power, W</source>
        <translation>Leistung, W</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Predicted %1: %2.</source>
        <translation>Vorhersage, %1: %2.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Radius of the upright arcs by which the tool comes into a pass from the air, and leaves one; smaller where the part is in the way; at first 0.1 of the tool&apos;s diameter</source>
        <translation>Radius der senkrechten Bögen, auf denen das Werkzeug aus der Luft in eine Bahn einfährt und sie verlässt; kleiner, wo das Teil im Weg ist; zunächst das 0.1-Fache des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Select faces that do not stand upright; edges or sketches as guides.</source>
        <translation>Flächen auswählen, die nicht senkrecht stehen; Kanten oder Skizzen als Leitkurven.</translation>
    </message>
    <message>
        <source>Select the faces that are to be finished, or a finishing operation.</source>
        <translation>Die zu schlichtenden Flächen auswählen, oder eine Schlichtoperation.</translation>
    </message>
    <message>
        <source>Set Operation</source>
        <translation>Operation setzen</translation>
    </message>
    <message>
        <source>Sets engagement angle, step down, spindle speed and feeds as suggested</source>
        <translation>Setzt Eingriffswinkel, Zustelltiefe, Spindeldrehzahl und Vorschübe wie vorgeschlagen</translation>
    </message>
    <message>
        <source>Shift along x</source>
        <translation>Entlang x verschieben</translation>
    </message>
    <message>
        <source>Shift along y</source>
        <translation>Entlang y verschieben</translation>
    </message>
    <message>
        <source>Shift along z</source>
        <translation>Entlang z verschieben</translation>
    </message>
    <message>
        <source>Side step, %s</source>
        <translation>Seitenzustellung, %s</translation>
    </message>
    <message>
        <source>Spiral inwards</source>
        <translation>Spirale nach innen</translation>
    </message>
    <message>
        <source>Spiral outwards</source>
        <translation>Spirale nach außen</translation>
    </message>
    <message>
        <source>Standard deviation of h_m: the less, the evener</source>
        <translation>Standardabweichung von h_m: je kleiner, desto gleichmäßiger</translation>
    </message>
    <message>
        <source>Step down, %s</source>
        <translation>Zustelltiefe, %s</translation>
    </message>
    <message>
        <source>Steps on a patch are measured on the centre or on the surface, not in plan.</source>
        <translation>Schritte auf einem Flächenstück werden an der Mitte oder auf der Fläche gemessen, nicht von oben.</translation>
    </message>
    <message>
        <source>Stock on the faces</source>
        <translation>Aufmaß auf den Flächen</translation>
    </message>
    <message>
        <source>Stops it</source>
        <translation>Bricht es ab</translation>
    </message>
    <message>
        <source>Stops the comparison; what is known stays</source>
        <translation>Bricht den Vergleich ab; was bekannt ist, bleibt</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>Suggest looks for the quickest cut within these limits.</source>
        <translation>„Vorschlagen“ sucht den schnellsten Schnitt innerhalb dieser Grenzen.</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>Suggest…</source>
        <translation>Vorschlagen…</translation>
    </message>
    <message>
        <source>Surface speed from</source>
        <translation>Schnittgeschw. von</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Taken into the panel.</source>
        <translation>In die Eingabemaske übernommen.</translation>
    </message>
    <message>
        <source>Taken: Undo sets what was before.</source>
        <translation>Übernommen: Rückgängig setzt, was vorher war.</translation>
    </message>
    <message>
        <source>Takes the plane face or datum plane that is selected</source>
        <translation>Nimmt die ausgewählte ebene Fläche oder Bezugsebene</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zähne</translation>
    </message>
    <message>
        <source>Tell Rz, or choose a finishing operation, whose cusps tell the least Rz.</source>
        <translation>Rz angeben, oder eine Schlichtoperation wählen, deren Rillen das kleinste Rz nennen.</translation>
    </message>
    <message>
        <source>That make the zone narrowest</source>
        <translation>Die die Zone am schmalsten machen</translation>
    </message>
    <message>
        <source>The %1 is %2, of %3 points, at a radius of %4.</source>
        <translation>%1: %2, aus %3 Punkten, bei einem Radius von %4.</translation>
    </message>
    <message>
        <source>The %1 is %2, of %3 points.</source>
        <translation>%1: %2, aus %3 Punkten.</translation>
    </message>
    <message>
        <source>The allowance must not be negative.</source>
        <translation>Das Flächenaufmaß darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>The axial depth, the stock&apos;s allowance, must lie above 0 mm and below the tool&apos;s radius.</source>
        <translation>Die axiale Tiefe, das Aufmaß, muss über 0 mm und unter dem Werkzeugradius liegen.</translation>
    </message>
    <message>
        <source>The ball does not fit into the concave surface: take a tool whose radius is smaller.</source>
        <translation>Die Kugel passt nicht in die konkave Fläche: ein Werkzeug mit kleinerem Radius nehmen.</translation>
    </message>
    <message>
        <source>The chip reaches beyond the lower half of the ball: the surface is too steep for a ball-end tool along its axis.</source>
        <translation>Der Span reicht über die untere Hälfte der Kugel hinaus: die Fläche ist zu steil für einen Kugelfräser entlang seiner Achse.</translation>
    </message>
    <message>
        <source>The comparison was cancelled.</source>
        <translation>Der Vergleich wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The corner&apos;s radius must lie between 0 and the tool&apos;s radius.</source>
        <translation>Der Eckenradius muss zwischen 0 und dem Werkzeugradius liegen.</translation>
    </message>
    <message>
        <source>The cusp height must be no more than the radius of the tool&apos;s ball or corner.</source>
        <translation>Die Rillenhöhe darf nicht größer sein als der Radius von Kugel oder Ecke des Werkzeugs.</translation>
    </message>
    <message>
        <source>The cusp height must not be negative.</source>
        <translation>Die Rillenhöhe darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>The datum is no longer there: choose another one.</source>
        <translation>Den Bezug gibt es nicht mehr: einen anderen wählen.</translation>
    </message>
    <message>
        <source>The datum is one plane: select a plane face or a datum plane.</source>
        <translation>Der Bezug ist eine Ebene: eine ebene Fläche oder eine Bezugsebene auswählen.</translation>
    </message>
    <message>
        <source>The feed direction is 0 to 90 degrees from the cylinder&apos;s axis.</source>
        <translation>Die Vorschubrichtung liegt 0 bis 90 Grad zur Zylinderachse.</translation>
    </message>
    <message>
        <source>The feed direction must be a number of degrees.</source>
        <translation>Die Vorschubrichtung muss eine Zahl von Grad sein.</translation>
    </message>
    <message>
        <source>The feed per tooth is too large beside the stepover: the tooth before does not bound the chip, which has no mean thickness by its face.</source>
        <translation>Der Vorschub je Zahn ist zu groß neben dem Bahnabstand: der Zahn davor begrenzt den Span nicht, der so keine mittlere Dicke nach seiner Fläche hat.</translation>
    </message>
    <message>
        <source>The feed per tooth must lie above 0 mm and below the tool&apos;s radius.</source>
        <translation>Der Vorschub je Zahn muss über 0 mm und unter dem Werkzeugradius liegen.</translation>
    </message>
    <message>
        <source>The file has points to measure, but no measured ones, FA(name)=FEAT/POINT,CART: open the file of results that the program writes.</source>
        <translation>Die Datei hat zu messende Punkte, aber keine gemessenen, FA(name)=FEAT/POINT,CART: die Ergebnisdatei öffnen, die das Programm schreibt.</translation>
    </message>
    <message>
        <source>The floors of &apos;%1&apos; lie at several depths: make an operation for each depth, and optimise one by one.</source>
        <translation>Die Böden von „%1“ liegen in mehreren Tiefen: für jede Tiefe eine Operation erstellen, und einzeln optimieren.</translation>
    </message>
    <message>
        <source>The guides cross each other: pick two that lie side by side.</source>
        <translation>Die Leitkurven kreuzen sich: zwei wählen, die nebeneinander liegen.</translation>
    </message>
    <message>
        <source>The highest of what stands between two passes</source>
        <translation>Das Höchste, was zwischen zwei Bahnen stehen bleibt</translation>
    </message>
    <message>
        <source>The job &apos;%1&apos; has no model with a shape: give it one.</source>
        <translation>Der Auftrag „%1“ hat kein Modell mit einer Form: ihm eines geben.</translation>
    </message>
    <message>
        <source>The largest of the tool in this material</source>
        <translation>Die größte des Werkzeugs in diesem Werkstoff</translation>
    </message>
    <message>
        <source>The largest share of a chip that is cut at less than a fifth of the tool&apos;s diameter</source>
        <translation>Der größte Anteil eines Spans, der bei weniger als einem Fünftel des Werkzeugdurchmessers geschnitten wird</translation>
    </message>
    <message>
        <source>The largest that its edges stand</source>
        <translation>Die größte, die seine Schneiden aushalten</translation>
    </message>
    <message>
        <source>The largest thickness of all chips</source>
        <translation>Die größte Dicke aller Späne</translation>
    </message>
    <message>
        <source>The lead radius must not be negative.</source>
        <translation>Der Ein-/Ausfahrradius darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>The least cutting speed of the working edge</source>
        <translation>Die kleinste Schnittgeschwindigkeit der arbeitenden Schneide</translation>
    </message>
    <message>
        <source>The least of the tool in this material</source>
        <translation>Die kleinste des Werkzeugs in diesem Werkstoff</translation>
    </message>
    <message>
        <source>The path of the tool of %1 mm touches no material: check the region and the hole.</source>
        <translation>Die Bahn des Werkzeugs von %1 mm berührt kein Material: Bereich und Loch prüfen.</translation>
    </message>
    <message>
        <source>The path of this strategy cuts nothing.</source>
        <translation>Die Bahn dieser Strategie schneidet nichts.</translation>
    </message>
    <message>
        <source>The plane in which the points were aligned</source>
        <translation>Die Ebene, in der die Punkte ausgerichtet wurden</translation>
    </message>
    <message>
        <source>The point %1 does not have six numbers after CART.</source>
        <translation>Der Punkt %1 hat keine sechs Zahlen nach CART.</translation>
    </message>
    <message>
        <source>The point %1 does not have six numbers, a normal among them.</source>
        <translation>Der Punkt %1 hat keine sechs Zahlen, darunter eine Normale.</translation>
    </message>
    <message>
        <source>The point %1 is told in polar coordinates: have the program write CART.</source>
        <translation>Der Punkt %1 steht in Polarkoordinaten: das Programm CART schreiben lassen.</translation>
    </message>
    <message>
        <source>The safe height must not lie below the top, nor the clearance height below it.</source>
        <translation>Die Sicherheitshöhe darf nicht unter der Oberseite liegen, noch die Freifahrhöhe unter ihr.</translation>
    </message>
    <message>
        <source>The spindle speed of &apos;%s&apos; is 0: set it, for the feed per tooth.</source>
        <translation>Die Spindeldrehzahl von „%s“ ist 0: sie setzen, für den Vorschub je Zahn.</translation>
    </message>
    <message>
        <source>The stepover makes too many passes: raise it.</source>
        <translation>Der Bahnabstand ergibt zu viele Bahnen: erhöhen.</translation>
    </message>
    <message>
        <source>The stepover must be positive and no more than the tool&apos;s diameter.</source>
        <translation>Der Bahnabstand muss positiv und nicht größer als der Werkzeugdurchmesser sein.</translation>
    </message>
    <message>
        <source>The stepover must lie above 0 mm and below the tool&apos;s diameter.</source>
        <translation>Der Bahnabstand muss über 0 mm und unter dem Werkzeugdurchmesser liegen.</translation>
    </message>
    <message>
        <source>The stock on the faces is %1 mm, and the ball&apos;s radius %2 mm: more than the ball can take; rough the part first.</source>
        <translation>Das Aufmaß auf den Flächen ist %1 mm, und der Kugelradius %2 mm: mehr, als die Kugel nehmen kann; das Teil zuerst schruppen.</translation>
    </message>
    <message>
        <source>The stock on the faces is %1 mm: it must be more than 0.</source>
        <translation>Das Aufmaß auf den Flächen ist %1 mm: muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>The surface speeds must rise.</source>
        <translation>Die Schnittgeschwindigkeiten müssen steigen.</translation>
    </message>
    <message>
        <source>The tolerance must be positive.</source>
        <translation>Die Toleranz muss positiv sein.</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; has no ball end, and the advisor&apos;s chips are those of a ball: choose a ball end mill.</source>
        <translation>Das Werkzeug „%1“ hat kein Kugelende, und die Späne des Beraters sind die einer Kugel: einen Kugelfräser wählen.</translation>
    </message>
    <message>
        <source>The tool controller &apos;%1&apos; has no spindle speed, and without it there is no feed per tooth: set it.</source>
        <translation>Die Werkzeugsteuerung „%1“ hat keine Spindeldrehzahl, und ohne sie gibt es keinen Vorschub je Zahn: sie setzen.</translation>
    </message>
    <message>
        <source>The tool controller has no spindle speed now.</source>
        <translation>Die Werkzeugsteuerung hat jetzt keine Spindeldrehzahl.</translation>
    </message>
    <message>
        <source>The tool touches none of the picked faces: take a smaller one, or lower FinalDepth.</source>
        <translation>Das Werkzeug berührt keine der gewählten Flächen: ein kleineres nehmen, oder [FinalDepth] senken.</translation>
    </message>
    <message>
        <source>The tool touches the faces nowhere but at edges.</source>
        <translation>Das Werkzeug berührt die Flächen nur an Kanten.</translation>
    </message>
    <message>
        <source>The tool touches the faces nowhere but at their borders.</source>
        <translation>Das Werkzeug berührt die Flächen nur an ihren Rändern.</translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be above 0 mm.</source>
        <translation>Der Werkzeugdurchmesser muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The tool&apos;s radius must be positive.</source>
        <translation>Der Werkzeugradius muss positiv sein.</translation>
    </message>
    <message>
        <source>Their strategy</source>
        <translation>Ihre Strategie</translation>
    </message>
    <message>
        <source>There is no edge on %1: pick the geometry anew.</source>
        <translation>Auf %1 gibt es keine Kante: die Geometrie neu wählen.</translation>
    </message>
    <message>
        <source>Thickest</source>
        <translation>Größte Dicke</translation>
    </message>
    <message>
        <source>Times are within its limits, too</source>
        <translation>Zeiten gelten auch innerhalb ihrer Grenzen</translation>
    </message>
    <message>
        <source>Tip share</source>
        <translation>Anteil Spitze</translation>
    </message>
    <message>
        <source>To try</source>
        <translation>Zu versuchen</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tool radius</source>
        <translation>Werkzeugradius</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Torque, N m</source>
        <translation>Drehmoment, N m</translation>
    </message>
    <message>
        <source>Turn about x</source>
        <translation>Um x drehen</translation>
    </message>
    <message>
        <source>Turn about y</source>
        <translation>Um y drehen</translation>
    </message>
    <message>
        <source>Turn about z</source>
        <translation>Um z drehen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Violet to yellow</source>
        <translation>Violett bis Gelb</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Was verglichen wird</translation>
    </message>
    <message>
        <source>What is taken off the face</source>
        <translation>Was von der Fläche abgenommen wird</translation>
    </message>
    <message>
        <source>What measured points say</source>
        <translation>Was gemessene Punkte sagen</translation>
    </message>
    <message>
        <source>What the cut before has left, across them</source>
        <translation>Was der Schnitt davor übrig ließ, quer zu ihnen</translation>
    </message>
    <message>
        <source>What to expect of a finishing</source>
        <translation>Was von einem Schlichten zu erwarten ist</translation>
    </message>
    <message>
        <source>What tool and machine allow, beside what is set now</source>
        <translation>Was Werkzeug und Maschine erlauben, neben dem jetzt Gesetzten</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Whether the tolerance of %1 is kept is not decided: measure more points.</source>
        <translation>Ob die Toleranz von %1 eingehalten ist, ist nicht entschieden: mehr Punkte messen.</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Windows that tell times begin with it</source>
        <translation>Fenster, die Zeiten nennen, beginnen mit ihr</translation>
    </message>
    <message>
        <source>Within the limits of the machine</source>
        <translation>Innerhalb der Grenzen der Maschine</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>Rattern</translation>
    </message>
    <message>
        <source>chip thickness</source>
        <translation>Spandicke</translation>
    </message>
    <message>
        <source>depth %1, not %2 %3</source>
        <translation>Tiefe %1, nicht %2 %3</translation>
    </message>
    <message>
        <source>face radius %1, not %2 %3</source>
        <translation>Flächenradius %1, nicht %2 %3</translation>
    </message>
    <message>
        <source>feed per tooth %1, not %2 %3</source>
        <translation>Vorschub je Zahn %1, nicht %2 %3</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>passes %1, not %2</source>
        <translation>Bahnen %1, nicht %2</translation>
    </message>
    <message>
        <source>profile of a surface in the datum</source>
        <translation>Profil einer Fläche zum Bezug</translation>
    </message>
    <message>
        <source>profile of the round face in the datum</source>
        <translation>Profil der runden Fläche zum Bezug</translation>
    </message>
    <message>
        <source>spindle speed %1 rev/min, not %2</source>
        <translation>Spindeldrehzahl %1 U/min, nicht %2</translation>
    </message>
    <message>
        <source>stepover %1, not %2 %3</source>
        <translation>Bahnabstand %1, nicht %2 %3</translation>
    </message>
    <message>
        <source>the area left</source>
        <translation>die Restfläche</translation>
    </message>
    <message>
        <source>the force</source>
        <translation>die Kraft</translation>
    </message>
    <message>
        <source>the machine&apos;s feed</source>
        <translation>der Maschinenvorschub</translation>
    </message>
    <message>
        <source>the power</source>
        <translation>die Leistung</translation>
    </message>
    <message>
        <source>the spindle speed</source>
        <translation>die Spindeldrehzahl</translation>
    </message>
    <message>
        <source>the tool&apos;s diameter</source>
        <translation>der Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>the tools&apos; chip thickness</source>
        <translation>die Spandicke</translation>
    </message>
    <message>
        <source>the tools&apos; cutting length</source>
        <translation>die Schneidenlänge</translation>
    </message>
    <message>
        <source>the torque</source>
        <translation>das Drehmoment</translation>
    </message>
    <message>
        <source>tool radius %1, not %2 %3</source>
        <translation>Werkzeugradius %1, nicht %2 %3</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Close the open panel first.</source>
        <translation>Zuerst die offene Eingabemaske schließen.</translation>
    </message>
    <message>
        <source>Limited by</source>
        <translation>Begrenzt durch</translation>
    </message>
    <message>
        <source>The suggestion was cancelled.</source>
        <translation>Die Suche nach einem Vorschlag wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The datum of the inspection is no longer there: it goes on without one.</source>
        <translation>Den Bezug der Prüfung gibt es nicht mehr: es geht ohne Bezug weiter.</translation>
    </message>
    <message>
        <source>The operation is no longer there: choose another one.</source>
        <translation>Die Operation gibt es nicht mehr: eine andere wählen.</translation>
    </message>
    <message>
        <source>Compare %s with</source>
        <translation>%s vergleichen mit</translation>
    </message>
    <message>
        <source>EvenLoad Compare</source>
        <translation>EvenLoad Vergleichen</translation>
    </message>
    <message>
        <source>EvenLoad Report</source>
        <translation>EvenLoad Bericht</translation>
    </message>
    <message>
        <source>Simulating the operations of %s</source>
        <translation>Die Operationen von %s werden simuliert</translation>
    </message>
    <message>
        <source>There is no browser for the report: %s</source>
        <translation>Es gibt keinen Browser für den Bericht: %s</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cuts nothing: there is nothing to simulate.</source>
        <translation>„%1“ schneidet nichts: es gibt nichts zu simulieren.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has a ball end mill, whose loads are not simulated: EvenLoad Show Surface, or evenload.surface_simulation, tells what it leaves on the faces.</source>
        <translation>„%1“ hat einen Kugelfräser, dessen Belastung nicht simuliert wird: EvenLoad Oberfläche zeigen oder evenload.surface_simulation nennt, was er auf den Flächen lässt.</translation>
    </message>
    <message>
        <source>95 % of cusps below</source>
        <translation>95 % der Rillen unter</translation>
    </message>
    <message>
        <source>A click near an open side in the 3D view: over that side the tool comes in first</source>
        <translation>Ein Klick nahe einer offenen Seite in der 3D-Ansicht: über diese Seite kommt das Werkzeug zuerst herein</translation>
    </message>
    <message>
        <source>Cells of %1 mm are coarse beside a stepover of %2 mm: cusps may be missed.</source>
        <translation>Zellen von %1 mm sind grob neben einem Bahnabstand von %2 mm: Rillen können übersehen werden.</translation>
    </message>
    <message>
        <source>Chips are told along an EvenLoad Finishing only.</source>
        <translation>Späne werden nur entlang eines EvenLoad Schlichtens genannt.</translation>
    </message>
    <message>
        <source>Colours the faces by what the path leaves on them, or ends that</source>
        <translation>Färbt die Flächen nach dem, was die Bahn auf ihnen lässt, oder beendet das</translation>
    </message>
    <message>
        <source>Cusps, mean</source>
        <translation>Rillen, im Mittel</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Konturverletzung</translation>
    </message>
    <message>
        <source>Height over the part</source>
        <translation>Höhe über dem Teil</translation>
    </message>
    <message>
        <source>Largest gouge</source>
        <translation>Größte Konturverletzung</translation>
    </message>
    <message>
        <source>Largest shown</source>
        <translation>Größter gezeigter Wert</translation>
    </message>
    <message>
        <source>Mean chip thickness h_m</source>
        <translation>Mittlere Spandicke h_m</translation>
    </message>
    <message>
        <source>None of the picked faces lies on top: others of the models hide them.</source>
        <translation>Keine der gewählten Flächen liegt oben: andere der Modelle verdecken sie.</translation>
    </message>
    <message>
        <source>Not cut</source>
        <translation>Nicht geschnitten</translation>
    </message>
    <message>
        <source>Open side at</source>
        <translation>Offene Seite bei</translation>
    </message>
    <message>
        <source>Pick the Open Side</source>
        <translation>Offene Seite wählen</translation>
    </message>
    <message>
        <source>Share of the tip</source>
        <translation>Anteil der Spitze</translation>
    </message>
    <message>
        <source>Stops the simulation; what is known stays</source>
        <translation>Hält die Simulation an; was bekannt ist, bleibt</translation>
    </message>
    <message>
        <source>Surface of %s</source>
        <translation>Oberfläche von %s</translation>
    </message>
    <message>
        <source>The models have no surface that looks up: nothing can be simulated.</source>
        <translation>Die Modelle haben keine Oberfläche, die nach oben schaut: nichts kann simuliert werden.</translation>
    </message>
    <message>
        <source>The path of &apos;%1&apos; lies beside the models.</source>
        <translation>Die Bahn von „%1“ liegt neben den Modellen.</translation>
    </message>
    <message>
        <source>The resolution is %1 mm: it must be at least %2 mm.</source>
        <translation>Die Auflösung ist %1 mm: muss mindestens %2 mm sein.</translation>
    </message>
    <message>
        <source>The resolution of %1 mm makes too many cells: choose at least %2 mm.</source>
        <translation>Die Auflösung von %1 mm ergibt zu viele Zellen: mindestens %2 mm wählen.</translation>
    </message>
    <message>
        <source>The tolerance is %1 mm: it must be at least %2 mm.</source>
        <translation>Die Toleranz ist %1 mm: muss mindestens %2 mm sein.</translation>
    </message>
    <message>
        <source>The tool first comes in over the open side that is nearest to this place</source>
        <translation>Das Werkzeug kommt zuerst über die offene Seite herein, die dieser Stelle am nächsten liegt</translation>
    </message>
    <message>
        <source>The triangles leave the part by up to %1 mm, and cusps are told no better than that: a finer tolerance takes longer.</source>
        <translation>Die Dreiecke weichen um bis zu %1 mm vom Teil ab, und Rillen werden nicht genauer genannt: eine feinere Toleranz dauert länger.</translation>
    </message>
    <message>
        <source>Within 10 % of the wish</source>
        <translation>Auf 10 % wie gewünscht</translation>
    </message>
    <message>
        <source>Writes what the faces are coloured by</source>
        <translation>Schreibt, wonach die Flächen gefärbt sind</translation>
    </message>
    <message>
        <source>not cut</source>
        <translation>nicht geschnitten</translation>
    </message>
    <message>
        <source>The cusp height makes too many passes: raise it.</source>
        <translation>Die Rillenhöhe ergibt zu viele Bahnen: erhöhen.</translation>
    </message>
    <message>
        <source>What is the same between all passes: their distance seen from above, or the height of what stands between them</source>
        <translation>Was zwischen allen Bahnen gleich ist: ihr Abstand von oben gesehen, oder die Höhe dessen, was zwischen ihnen stehen bleibt</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Verlängerung</translation>
    </message>
    <message>
        <source>How far passes go on beyond the border of the faces, seen from above: along what goes on there or falls away, not up what rises</source>
        <translation>Wie weit die Bahnen von oben gesehen über den Rand der Flächen hinausgehen: entlang dessen, was dort weitergeht oder abfällt, nicht hinauf, wo etwas ansteigt</translation>
    </message>
    <message>
        <source>One way between guides</source>
        <translation>Eine Richtung zwischen Leitkurven</translation>
    </message>
    <message>
        <source>Parallel passes to and fro, or all in one direction with a way back over the part; passes along the outline of the faces, or a spiral round their middle, from the outside or from the inside on; or passes between two picked edges, from the shape of one to the other&apos;s, to and fro or all in one direction</source>
        <translation>Parallele Bahnen hin und her, oder alle in einer Richtung mit einem Rückweg über dem Teil; Bahnen entlang des Umrisses der Flächen, oder eine Spirale um ihre Mitte, von außen oder von innen her; oder Bahnen zwischen zwei gewählten Kanten, von der Form der einen zu der der anderen, hin und her oder alle in einer Richtung</translation>
    </message>
    <message>
        <source>The extension must not be negative.</source>
        <translation>Die Verlängerung darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%d, of %s</source>
        <translation>%d, aus %s</translation>
    </message>
    <message>
        <source>%s to %s %s</source>
        <translation>%s bis %s %s</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Schranke</translation>
    </message>
    <message>
        <source>By the regressions of ten milled parts, for a %s face, passes at %g° to its axis, Rz %s.</source>
        <translation>Nach den Regressionen aus zehn gefrästen Teilen, für eine %se Fläche, Bahnen unter %g° zu ihrer Achse, Rz %s.</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Contact, point</source>
        <translation>Kontakt, Punkt</translation>
    </message>
    <message>
        <source>Datum plane</source>
        <translation>Bezugsebene</translation>
    </message>
    <message>
        <source>Deviation, %s</source>
        <translation>Abweichung, %s</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>Engagement along %s</source>
        <translation>Eingriff entlang %s</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Incident</source>
        <translation>Vorfall</translation>
    </message>
    <message>
        <source>Incidents: %d, see below.</source>
        <translation>Vorfälle: %d, siehe unten.</translation>
    </message>
    <message>
        <source>Inspection of %s</source>
        <translation>Prüfung von %s</translation>
    </message>
    <message>
        <source>Load of %s over time</source>
        <translation>Last von %s über der Zeit</translation>
    </message>
    <message>
        <source>Map of the deviations</source>
        <translation>Karte der Abweichungen</translation>
    </message>
    <message>
        <source>Material of the forces</source>
        <translation>Werkstoff der Kräfte</translation>
    </message>
    <message>
        <source>Measured, %s</source>
        <translation>Gemessen, %s</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>Multiplikator</translation>
    </message>
    <message>
        <source>No gouge, no rapid or plunge in material.</source>
        <translation>Keine Konturverletzung, nichts im Eilgang oder senkrecht in Material.</translation>
    </message>
    <message>
        <source>No incidents.</source>
        <translation>Keine Vorfälle.</translation>
    </message>
    <message>
        <source>No incidents; what must stay is not known for %s.</source>
        <translation>Keine Vorfälle; was stehen bleiben muss, ist nicht bekannt für %s.</translation>
    </message>
    <message>
        <source>Not in the times</source>
        <translation>Nicht in den Zeiten</translation>
    </message>
    <message>
        <source>Not listed: %d more.</source>
        <translation>Nicht aufgeführt: %d weitere.</translation>
    </message>
    <message>
        <source>Not simulated: %s.</source>
        <translation>Nicht simuliert: %s.</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Plunge in material</source>
        <translation>Senkrecht in Material</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Predicted, %s</source>
        <translation>Vorhersage, %s</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Rapid in material</source>
        <translation>Eilgang in Material</translation>
    </message>
    <message>
        <source>Rest and incidents of %s</source>
        <translation>Restmaterial und Vorfälle von %s</translation>
    </message>
    <message>
        <source>R² adjusted</source>
        <translation>R² bereinigt</translation>
    </message>
    <message>
        <source>Shift of the points</source>
        <translation>Verschiebung der Punkte</translation>
    </message>
    <message>
        <source>Simulation of %s</source>
        <translation>Simulation von %s</translation>
    </message>
    <message>
        <source>The job has no active operation.</source>
        <translation>Der Auftrag hat keine aktive Operation.</translation>
    </message>
    <message>
        <source>The minimum zone is not proved; what is left of the forces&apos; balance is %.1e.</source>
        <translation>Die Minimum-Zone ist nicht bewiesen; was vom Gleichgewicht der Kräfte bleibt, ist %.1e.</translation>
    </message>
    <message>
        <source>The minimum zone is proved; what is left of the forces&apos; balance is %.1e.</source>
        <translation>Die Minimum-Zone ist bewiesen; was vom Gleichgewicht der Kräfte bleibt, ist %.1e.</translation>
    </message>
    <message>
        <source>Time at the programmed feeds</source>
        <translation>Zeit mit programmierten Vorschüben</translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation>Zeit auf der Maschine</translation>
    </message>
    <message>
        <source>Tool changes, dwells of the spindle, coolant</source>
        <translation>Werkzeugwechsel, Verweilen der Spindel, Kühlmittel</translation>
    </message>
    <message>
        <source>Turn of the points</source>
        <translation>Drehung der Punkte</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>konkav</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>konvex</translation>
    </message>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>inner</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>none, as aligned</source>
        <translation>keine, wie ausgerichtet</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>through %s %s, normal %s</source>
        <translation>durch %s %s, Normale %s</translation>
    </message>
    <message>
        <source>%.0f s on the machine</source>
        <translation>%.0f s auf der Maschine</translation>
    </message>
    <message>
        <source>%1 points on %2</source>
        <translation>%1 Punkte auf %2</translation>
    </message>
    <message>
        <source>, %.2f of the ideal</source>
        <translation>, %.2f des Ideals</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Rest and incidents</source>
        <translation>Restmaterial und Vorfälle</translation>
    </message>
    <message>
        <source>beyond the tolerance</source>
        <translation>außerhalb der Toleranz</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>deviation, %s; above 0: %s</source>
        <translation>Abweichung, %s; über 0: %s</translation>
    </message>
    <message>
        <source>engagement angle, degrees</source>
        <translation>Eingriffswinkel, Grad</translation>
    </message>
    <message>
        <source>engagement, degrees</source>
        <translation>Eingriff, Grad</translation>
    </message>
    <message>
        <source>force in XY, N</source>
        <translation>Kraft in XY, N</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>Konturverletzung</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>in a fixture</source>
        <translation>im Spannmittel</translation>
    </message>
    <message>
        <source>largest engagement %.1f°</source>
        <translation>größter Eingriff %.1f°</translation>
    </message>
    <message>
        <source>largest force %.0f N</source>
        <translation>größte Kraft %.0f N</translation>
    </message>
    <message>
        <source>mean of a revolution</source>
        <translation>Mittel einer Umdrehung</translation>
    </message>
    <message>
        <source>no material, no forces</source>
        <translation>kein Werkstoff, keine Kräfte</translation>
    </message>
    <message>
        <source>no rest, no incidents</source>
        <translation>kein Restmaterial, keine Vorfälle</translation>
    </message>
    <message>
        <source>outside of the feature</source>
        <translation>außerhalb des Elements</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>part, top at z = %g</source>
        <translation>Teil, Oberseite bei z = %g</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>plunge in material</source>
        <translation>senkrecht in Material</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>rapid in material</source>
        <translation>Eilgang in Material</translation>
    </message>
    <message>
        <source>reference %.4g N</source>
        <translation>Bezugswert %.4g N</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>target %.4g°</source>
        <translation>Ziel %.4g°</translation>
    </message>
    <message>
        <source>too much material</source>
        <translation>zu viel Material</translation>
    </message>
    <message>
        <source>%s: %d s, %d passes</source>
        <translation>%s: %d s, %d Bahnen</translation>
    </message>
    <message>
        <source>Choose the open side</source>
        <translation>Offene Seite wählen</translation>
    </message>
    <message>
        <source>How the tool reaches its depth; Automatic: an open side, else a set hole, else a helix, else a ramp</source>
        <translation>Wie das Werkzeug seine Tiefe erreicht; Automatisch: eine offene Seite, sonst ein gesetztes Loch, sonst eine Helix, sonst eine Rampe</translation>
    </message>
    <message>
        <source>No side of %1 is open, over which the tool could come in: turn ChooseOpenSide off.</source>
        <translation>Keine Seite von %1 ist offen, über die das Werkzeug hereinkommen könnte: [ChooseOpenSide] ausschalten.</translation>
    </message>
    <message>
        <source>Whether the open side over which the tool first comes in is chosen by a place</source>
        <translation>Ob die offene Seite, über die das Werkzeug zuerst hereinkommt, durch eine Stelle gewählt wird</translation>
    </message>
    <message>
        <source>A Lamé spiral around an island begins beside its wall: drill the hole there, or choose the entry &apos;Automatic&apos;.</source>
        <translation>Eine Lamé-Spirale um eine Insel beginnt neben deren Wand: das Loch dort bohren, oder das Eintauchen „Automatisch“ wählen.</translation>
    </message>
    <message>
        <source>A Lamé spiral around an island in open stock comes from outside, not from a hole: choose the entry &apos;Automatic&apos;.</source>
        <translation>Eine Lamé-Spirale um eine Insel in offenem Rohteil kommt von außen, nicht aus einem Loch: das Eintauchen „Automatisch“ wählen.</translation>
    </message>
    <message>
        <source>A Lamé spiral clears pockets without islands, or with one island and an outline that is all wall or all open: take the operation Adaptive.</source>
        <translation>Eine Lamé-Spirale räumt Taschen ohne Inseln aus, oder mit einer Insel und einem Umriss, der ganz Wand oder ganz offen ist: die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>A Lamé spiral would clear only %1 % of this pocket: take the operation Adaptive.</source>
        <translation>Eine Lamé-Spirale würde nur %1 % dieser Tasche ausräumen: die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>An island</source>
        <translation>Eine Insel</translation>
    </message>
    <message>
        <source>Between the walls there is too little room for a Lamé spiral: take the operation Adaptive.</source>
        <translation>Zwischen den Wänden ist zu wenig Platz für eine Lamé-Spirale: die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>Centre lies outside the pocket: move it inside, or leave it unset.</source>
        <translation>[Centre] liegt außerhalb der Tasche: hinein verschieben, oder nicht setzen.</translation>
    </message>
    <message>
        <source>No Lamé curve resembles this pocket: take the operation Adaptive.</source>
        <translation>Keine Lamé-Kurve ähnelt dieser Tasche: die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>No Lamé spiral keeps to the engagement angle in this pocket: take the operation Adaptive.</source>
        <translation>Keine Lamé-Spirale hält in dieser Tasche den Eingriffswinkel ein: die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>No Lamé spiral leads from one outline of this pocket to the other: take the operation Adaptive.</source>
        <translation>Keine Lamé-Spirale führt von einem Umriss dieser Tasche zum anderen: die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>No Lamé spiral leads from the pre-drilled hole to the pocket&apos;s walls: move EntryPoint towards the middle, or choose the entry &apos;Helix&apos;.</source>
        <translation>Keine Lamé-Spirale führt vom vorgebohrten Loch zu den Wänden der Tasche: [EntryPoint] zur Mitte hin verschieben, oder das Eintauchen „Helix“ wählen.</translation>
    </message>
    <message>
        <source>Only curves of four segments have two courses: set SemiAxisACourse and SemiAxisBCourse to the same values, or leave one of them empty.</source>
        <translation>Nur Kurven mit vier Segmenten haben zwei Verläufe: [SemiAxisACourse] und [SemiAxisBCourse] auf dieselben Werte setzen, oder eines davon leer lassen.</translation>
    </message>
    <message>
        <source>SemiAxisA and SemiAxisB leave no room for a spiral around its entry: set larger ones, or leave them unset.</source>
        <translation>[SemiAxisA] und [SemiAxisB] lassen keinen Platz für eine Spirale um ihr Eintauchen: größere setzen, oder nicht setzen.</translation>
    </message>
    <message>
        <source>The pre-drilled hole is too tight to start a spiral from: drill it wider, move EntryPoint towards the middle, or choose the entry &apos;Helix&apos;.</source>
        <translation>Das vorgebohrte Loch ist zu eng, um darin eine Spirale zu beginnen: weiter bohren, [EntryPoint] zur Mitte hin verschieben, oder das Eintauchen „Helix“ wählen.</translation>
    </message>
    <message>
        <source>The pre-drilled hole lies outside this pocket: choose the entry &apos;Automatic&apos;, or another hole.</source>
        <translation>Das vorgebohrte Loch liegt außerhalb dieser Tasche: das Eintauchen „Automatisch“ wählen, oder ein anderes Loch.</translation>
    </message>
    <message>
        <source>The tool of %1 mm does not fit into the pocket: %2</source>
        <translation>Das Werkzeug von %1 mm passt nicht in die Tasche: %2</translation>
    </message>
    <message>
        <source>With the set Segments, ExponentEnd or Rotation the largest spiral would clear %1 % of this pocket: leave them unset, or take the operation Adaptive.</source>
        <translation>Mit dem, was gesetzt ist ([Segments], [ExponentEnd] oder [Rotation]), würde die größte Spirale %1 % dieser Tasche ausräumen: nicht setzen, oder die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>With the set properties no Lamé curve keeps clear of the walls: leave some of them unset, or take the operation Adaptive.</source>
        <translation>Mit den gesetzten Eigenschaften bleibt keine Lamé-Kurve von den Wänden weg: einige davon nicht setzen, oder die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>With these courses no Lamé spiral keeps to the engagement angle: make SemiAxisACourse, SemiAxisBCourse and ExponentCourse more even, or leave them empty.</source>
        <translation>Mit diesen Verläufen hält keine Lamé-Spirale den Eingriffswinkel ein: [SemiAxisACourse], [SemiAxisBCourse] und [ExponentCourse] gleichmäßiger machen, oder leer lassen.</translation>
    </message>
    <message>
        <source>With these courses no Lamé spiral leads from its first turn to its last: leave SemiAxisACourse, SemiAxisBCourse and ExponentCourse empty, or take the operation Adaptive.</source>
        <translation>Mit diesen Verläufen führt keine Lamé-Spirale von ihrer ersten Windung zur letzten: [SemiAxisACourse], [SemiAxisBCourse] und [ExponentCourse] leer lassen, oder die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>With this Centre the largest spiral would clear %1 % of this pocket: move Centre towards the middle, leave it unset, or take the operation Adaptive.</source>
        <translation>Mit diesem Wert von [Centre] würde die größte Spirale %1 % dieser Tasche ausräumen: [Centre] zur Mitte hin verschieben, nicht setzen, oder die Operation Adaptiv nehmen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cuts the faces nowhere.</source>
        <translation>„%1“ schneidet die Flächen nirgends.</translation>
    </message>
    <message>
        <source>Places of the patch are %1 mm apart, coarse beside marks of %2 mm, which may be lost: a smaller patch would tell them.</source>
        <translation>Die Stellen des Ausschnitts liegen %1 mm auseinander, grob neben Spuren von %2 mm, die verloren gehen können: ein kleinerer Ausschnitt würde sie zeigen.</translation>
    </message>
    <message>
        <source>R_z across the feed</source>
        <translation>R_z quer zum Vorschub</translation>
    </message>
    <message>
        <source>R_z along the feed</source>
        <translation>R_z längs des Vorschubs</translation>
    </message>
    <message>
        <source>What &apos;%1&apos; cuts is narrower than a patch of %2 mm, whose roughness is told: pick wider faces.</source>
        <translation>Was „%1“ schneidet, ist schmaler als ein Ausschnitt von %2 mm, dessen Rauheit angegeben wird: breitere Flächen wählen.</translation>
    </message>
    <message>
        <source>FeedControl is &apos;%1&apos;, but the tool &apos;%2&apos; has no ball end, and the chips that are known are those of a ball: take a ball end mill, or another FeedControl.</source>
        <translation>[FeedControl] ist &apos;%1&apos;, aber das Werkzeug &apos;%2&apos; hat kein Kugelende, und bekannt sind nur die Späne einer Kugel: einen Kugelfräser nehmen oder eine andere [FeedControl].</translation>
    </message>
    <message>
        <source>FeedControl is &apos;%1&apos;, but without a spindle speed there is no feed per tooth: set that of the tool controller.</source>
        <translation>[FeedControl] ist &apos;%1&apos;, aber ohne Spindeldrehzahl gibt es keinen Vorschub je Zahn: die der Werkzeugsteuerung setzen.</translation>
    </message>
    <message>
        <source>Feeds of the cuts: %1 to %2 mm/min, for chips with a mean thickness of %3 µm.</source>
        <translation>Vorschübe der Schnitte: %1 bis %2 mm/min, für Späne mit einer mittleren Dicke von %3 µm.</translation>
    </message>
    <message>
        <source>StockOnFaces is %1 mm: it must lie between 0 and the ball&apos;s radius of %2 mm.</source>
        <translation>[StockOnFaces] ist %1 mm: Es muss zwischen 0 und dem Kugelradius von %2 mm liegen.</translation>
    </message>
    <message>
        <source>What stays the same along the cuts: the feed, or the mean thickness of a ball&apos;s chips</source>
        <translation>Was entlang der Schnitte gleich bleibt: der Vorschub oder die mittlere Dicke der Späne einer Kugel</translation>
    </message>
    <message>
        <source>What the cut before has left above the surface that is made, across it: the feed control&apos;s chips are of that; at first 0.03 of the tool&apos;s diameter</source>
        <translation>Was die Bearbeitung davor über der entstehenden Fläche stehen ließ, quer zu ihr: Daraus sind die Späne der Vorschubregelung; zunächst 0,03 des Werkzeugdurchmessers</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no faces that the tool could keep off: take it out of Fixtures.</source>
        <translation>&apos;%1&apos; hat keine Flächen, von denen das Werkzeug wegbleiben könnte: es aus [Fixtures] herausnehmen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a model of the job, which the tool keeps off anyway: take it out of Fixtures.</source>
        <translation>&apos;%1&apos; ist ein Modell des Auftrags, von dem das Werkzeug ohnehin wegbleibt: es aus [Fixtures] herausnehmen.</translation>
    </message>
    <message>
        <source>Clamps, vices and other objects that the tool keeps off, as from above: what lies below them is not cut. The button takes what is selected</source>
        <translation>Spanneisen, Schraubstöcke und anderes, von dem das Werkzeug wegbleibt, wie von oben: Was darunter liegt, wird nicht bearbeitet. Der Knopf nimmt, was ausgewählt ist</translation>
    </message>
    <message>
        <source>Fixture clearance</source>
        <translation>Abstand der Spannmittel</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>How far the tool stays off the fixtures, all around</source>
        <translation>Wie weit das Werkzeug rundum von den Spannmitteln wegbleibt</translation>
    </message>
    <message>
        <source>SafeHeight (%1 mm) lies below the top of the fixtures and their clearance (%2 mm): raise it.</source>
        <translation>[SafeHeight] (%1 mm) liegt unter der Oberkante der Spannmittel samt ihrem Abstand (%2 mm): erhöhen.</translation>
    </message>
    <message>
        <source>The clearance of fixtures must not be negative.</source>
        <translation>Der Abstand der Spannmittel darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>The fixtures leave the tool none of the picked faces: move them, or lower FixtureClearance.</source>
        <translation>Die Spannmittel lassen dem Werkzeug keine der ausgewählten Flächen: sie versetzen oder [FixtureClearance] verringern.</translation>
    </message>
    <message>
        <source>EvenLoad Lame Spiral</source>
        <translation>EvenLoad Lamé-Spirale</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one, the surface&apos;s triangles included; into the part usually a third of it, at the most half</source>
        <translation>Größter Abstand der Bahn von der genauen, die Dreiecke der Fläche eingeschlossen; in das Teil hinein meist ein Drittel davon, höchstens die Hälfte</translation>
    </message>
    <message>
        <source>The tool &apos;%1&apos; does not tell its number of teeth: 1 tooth is assumed.</source>
        <translation>Das Werkzeug „%1“ nennt seine Zähnezahl nicht: 1 Zahn wird angenommen.</translation>
    </message>
    <message>
        <source>%.0f rev/min, %.3g %s</source>
        <translation>%.0f U/min, %.3g %s</translation>
    </message>
    <message>
        <source>Amount, %s</source>
        <translation>Betrag, %s</translation>
    </message>
    <message>
        <source>Engagement, %s</source>
        <translation>Eingriff, %s</translation>
    </message>
    <message>
        <source>Gouge, %s</source>
        <translation>Konturverletzung, %s</translation>
    </message>
    <message>
        <source>Peak force, %s</source>
        <translation>Spitzenkraft, %s</translation>
    </message>
    <message>
        <source>Removal rate, %s</source>
        <translation>Zeitspanvolumen, %s</translation>
    </message>
    <message>
        <source>Removes %.3g %s, now %.3g; location error %s, force %.0f N.</source>
        <translation>Trägt %.3g %s ab, jetzt %.3g; Lagefehler %s, Kraft %.0f N.</translation>
    </message>
    <message>
        <source>Rest, %s</source>
        <translation>Restmaterial, %s</translation>
    </message>
    <message>
        <source>axial depth, %s</source>
        <translation>Zustelltiefe, %s</translation>
    </message>
    <message>
        <source>gouge %s</source>
        <translation>Konturverletzung %s</translation>
    </message>
    <message>
        <source>nominal %s</source>
        <translation>Nennwert %s</translation>
    </message>
    <message>
        <source>plunges in material %s</source>
        <translation>senkrecht in Material %s</translation>
    </message>
    <message>
        <source>rapids in material %s</source>
        <translation>Eilgänge in Material %s</translation>
    </message>
    <message>
        <source>removal rate, %s</source>
        <translation>Zeitspanvolumen, %s</translation>
    </message>
    <message>
        <source>rest %s</source>
        <translation>Restmaterial %s</translation>
    </message>
    <message>
        <source>height of the tool&apos;s tip above z = %.3f, %s</source>
        <translation>Höhe der Werkzeugspitze über z = %.3f, %s</translation>
    </message>
    <message>
        <source>EngagementAngle and SideStep both have an expression, though each sets the other: take one of the two away.</source>
        <translation>[EngagementAngle] und [SideStep] haben beide einen Ausdruck, obwohl jedes das andere setzt: einen der beiden entfernen.</translation>
    </message>
    <message>
        <source>cut along a wall</source>
        <translation>Schnitt entlang einer Wand</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not active: activate it first.</source>
        <translation>„%1“ ist nicht aktiv: zuerst aktivieren.</translation>
    </message>
    <message>
        <source>SideStep is %1 mm, less than the Tolerance of %2 mm: lower Tolerance or raise EngagementAngle.</source>
        <translation>[SideStep] ist %1 mm, weniger als [Tolerance] von %2 mm: [Tolerance] senken oder [EngagementAngle] erhöhen.</translation>
    </message>
    <message>
        <source>The preview is shown; Apply or Cancel brings the load back.</source>
        <translation>Die Vorschau wird gezeigt; Anwenden oder Abbrechen bringt die Belastung zurück.</translation>
    </message>
    <message>
        <source>Cancelled: what is shown was simulated before.</source>
        <translation>Abgebrochen: was gezeigt wird, wurde vorher simuliert.</translation>
    </message>
    <message>
        <source>Set by the expression of &apos;%s&apos;</source>
        <translation>Vom Ausdruck von „%s“ gesetzt</translation>
    </message>
    <message>
        <source>Stops the simulation; colours come with the next path</source>
        <translation>Hält die Simulation an; Farben kommen mit der nächsten Bahn</translation>
    </message>
    <message>
        <source>The report was cancelled.</source>
        <translation>Der Bericht wurde abgebrochen.</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Adaptive</name>
    <message>
        <source>Clears pockets at constant engagement of the tool</source>
        <translation>Räumt Taschen mit konstantem Eingriff des Werkzeugs aus</translation>
    </message>
    <message>
        <source>EvenLoad Adaptive</source>
        <translation>EvenLoad Adaptiv</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Compare</name>
    <message>
        <source>EvenLoad Compare</source>
        <translation>EvenLoad Vergleichen</translation>
    </message>
    <message>
        <source>Shows the load of two selected operations over time on one scale; of one, asks which other one to set beside it</source>
        <translation>Zeigt die Belastung zweier gewählter Operationen über der Zeit in einem Maßstab; bei einer gewählten wird gefragt, welche andere danebenstehen soll</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Finishing</name>
    <message>
        <source>EvenLoad Finishing</source>
        <translation>EvenLoad Schlichten</translation>
    </message>
    <message>
        <source>Finishes faces by passes of a ball end, bull-nosed or flat tool</source>
        <translation>Schlichtet Flächen durch Bahnen eines Fräsers mit Kugelende, mit Eckenradius oder flach</translation>
    </message>
</context>
<context>
    <name>EvenLoad_FinishingAdvisor</name>
    <message>
        <source>Compares ten strategies for the selected faces or finishing operation by time, chips, cusps, tip and force, and makes an operation of one</source>
        <translation>Vergleicht zehn Strategien für die ausgewählten Flächen oder Schlichtoperation nach Zeit, Spänen, Rillen, Spitze und Kraft, und erstellt eine Operation daraus</translation>
    </message>
    <message>
        <source>EvenLoad Finishing Advisor</source>
        <translation>EvenLoad Schlichtberater</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Inspect</name>
    <message>
        <source>EvenLoad Inspect</source>
        <translation>EvenLoad Prüfen</translation>
    </message>
    <message>
        <source>Tells where to measure the selected faces, and how far measured points lie from them</source>
        <translation>Zeigt, wo die gewählten Flächen zu messen sind und wie weit gemessene Punkte von ihnen abweichen</translation>
    </message>
</context>
<context>
    <name>EvenLoad_LameSpiral</name>
    <message>
        <source>Clears round, square and many-sided pockets, and round islands of such shapes, by spirals</source>
        <translation>Räumt runde, quadratische und vieleckige Taschen, auch um Inseln solcher Form, durch Spiralen aus</translation>
    </message>
    <message>
        <source>EvenLoad Lamé Spiral</source>
        <translation>EvenLoad Lamé-Spirale</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Optimise</name>
    <message>
        <source>EvenLoad Optimise</source>
        <translation>EvenLoad Optimieren</translation>
    </message>
    <message>
        <source>Suggests engagement angle, step down, spindle speed and feeds within what tool and machine stand, beside what is set now</source>
        <translation>Schlägt Eingriffswinkel, Zustelltiefe, Spindeldrehzahl und Vorschübe vor, die Werkzeug und Maschine aushalten, neben dem jetzt Gesetzten</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Report</name>
    <message>
        <source>EvenLoad Report</source>
        <translation>EvenLoad Bericht</translation>
    </message>
    <message>
        <source>Simulates the operations of the job, writes a report to print and opens it in the browser</source>
        <translation>Simuliert die Operationen des Auftrags, schreibt einen Bericht zum Drucken und öffnet ihn im Browser</translation>
    </message>
</context>
<context>
    <name>EvenLoad_ShowLoad</name>
    <message>
        <source>Colours the path of the selected operation by engagement, removal rate, feed, chip thickness or force, or takes the colours away again</source>
        <translation>Färbt die Bahn der gewählten Operation nach Eingriff, Zeitspanvolumen, Vorschub, Spandicke oder Kraft, oder nimmt die Farben wieder weg</translation>
    </message>
    <message>
        <source>EvenLoad Show Load</source>
        <translation>EvenLoad Belastung zeigen</translation>
    </message>
</context>
<context>
    <name>EvenLoad_ShowSurface</name>
    <message>
        <source>Colours the faces below the selected operation by cusps, gouges, what is left, chip thickness or the tip&apos;s share, or takes the colours away again</source>
        <translation>Färbt die Flächen unter der gewählten Operation nach Rillen, Konturverletzungen, dem, was stehen bleibt, Spandicke oder dem Anteil der Spitze, oder nimmt die Farben wieder weg</translation>
    </message>
    <message>
        <source>EvenLoad Show Surface</source>
        <translation>EvenLoad Oberfläche zeigen</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Simulation</name>
    <message>
        <source>EvenLoad Simulation</source>
        <translation>EvenLoad Simulation</translation>
    </message>
    <message>
        <source>Shows engagement, removal rate and force of the selected operation over time, beside another one if wished, with a cursor in the 3D view</source>
        <translation>Zeigt Eingriff, Zeitspanvolumen und Kraft der gewählten Operation über der Zeit, auf Wunsch neben einer anderen, mit einem Zeiger in der 3D-Ansicht</translation>
    </message>
</context>
<context>
    <name>EvenLoad_StabilityChart</name>
    <message>
        <source>EvenLoad Stability Chart</source>
        <translation>EvenLoad Stabilitätskarte</translation>
    </message>
    <message>
        <source>Shows at which spindle speeds and depths an operation chatters, and finds the best cut</source>
        <translation>Zeigt, bei welchen Spindeldrehzahlen und Tiefen eine Operation rattert, und findet den besten Schnitt</translation>
    </message>
</context>
<context>
    <name>EvenLoad_Trochoid</name>
    <message>
        <source>Cuts slots by trochoids at constant engagement of the tool</source>
        <translation>Fräst Nuten durch Trochoiden mit konstantem Eingriff des Werkzeugs</translation>
    </message>
    <message>
        <source>EvenLoad Trochoid</source>
        <translation>EvenLoad Trochoide</translation>
    </message>
</context>
</TS>
