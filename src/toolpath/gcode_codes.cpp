#include "toolpath/gcode_codes.h"

namespace evenload {

GGroup group_of_g(int tenths) {
  switch (tenths) {
    case 40:
    case 100:
    case 280:
    case 300:
    case 520:
    case 530:
    case 920:
    case 921:
    case 922:
    case 923:
      return GGroup::kNonModal;
    case 0:
    case 10:
    case 20:
    case 30:
    case 730:
    case 740:
    case 760:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 870:
    case 880:
    case 890:
      return GGroup::kMotion;
    case 800:
      return GGroup::kCycleEnd;
    case 170:
    case 180:
    case 190:
      return GGroup::kPlane;
    case 900:
    case 910:
      return GGroup::kDistance;
    case 901:
    case 911:
      return GGroup::kArcDistance;
    case 930:
    case 940:
    case 950:
      return GGroup::kFeedMode;
    case 200:
    case 210:
      return GGroup::kUnits;
    case 400:
    case 410:
    case 420:
      return GGroup::kCompensation;
    case 430:
    case 440:
    case 490:
      return GGroup::kToolLength;
    case 980:
    case 990:
      return GGroup::kRetract;
    case 540:
    case 541:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 591:
    case 592:
    case 593:
    case 1540:
      return GGroup::kWorkCoordinates;
    case 610:
    case 611:
    case 640:
      return GGroup::kPathControl;
    case 960:
    case 970:
      return GGroup::kSpindleMode;
    case 500:
      return GGroup::kScaling;
    case 690:
      return GGroup::kRotation;
    case 150:
      return GGroup::kPolar;
    default:
      return GGroup::kUnknown;
  }
}

MGroup group_of_m(int tenths) {
  switch (tenths) {
    case 0:
    case 10:
    case 20:
    case 300:
    case 600:
      return MGroup::kStop;
    case 60:
      return MGroup::kToolChange;
    case 30:
    case 40:
    case 50:
      return MGroup::kSpindle;
    case 70:
    case 80:
    case 90:
    case 480:
    case 490:
    case 500:
    case 510:
    case 520:
    case 530:
      return MGroup::kAccepted;
    default:
      return MGroup::kUnknown;
  }
}

bool is_unread_motion(int tenths) {
  switch (tenths) {
    case 50:
    case 51:
    case 52:
    case 330:
    case 331:
    case 382:
    case 383:
    case 384:
    case 385:
    case 760:
      return true;
    default:
      return false;
  }
}

bool only_names_a_place(int tenths) {
  switch (tenths) {
    case 100:  // G10: offsets and tools
    case 520:  // G52: local coordinates
    case 920:  // G92: the present place
    case 431:  // G43.1: tool length
    case 510:  // G51: centre of scaling
    case 680:  // G68: centre of rotation
      return true;
    default:
      return false;
  }
}

}  // namespace evenload
