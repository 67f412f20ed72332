export { sharedIcons } from './appearance/sharedIcons';
export { Signal } from './Signal';
export { Selection } from './Selection';
export { countLabel, namesOf } from './labels';
export { shortText } from './shortText';

export type { Command, CommandSelection } from './history/Command';
export { CommandStack } from './history/CommandStack';
export type { EditRecorder } from './history/EditRecorder';
export { Gesture } from './history/Gesture';

export { currentOf, replaceOwner } from './fields/currentOf';
export type { FieldDescription, FieldTarget } from './fields/FieldTarget';
export { FieldGesture, type FieldUpdate } from './fields/FieldGesture';
export { type FieldEdit, SetFields } from './fields/SetFields';
export { sharedValue, type SharedValue, withCoordinate } from './fields/sharedValue';
export { toDegrees, toRadians } from './fields/angles';
export { describeField } from './fields/describeField';
export { addToNumber, type SteppedRange, stepFactor, suitsSlider, valueOnSlider } from './fields/drag';
export { matchesFilter, wordsOfFilter } from './fields/matchesFilter';
export { fieldInUnit } from './fields/fieldInUnit';
export { formatNumber, shownDecimals } from './fields/formatNumber';
export { englishLabelOfField, labelOfField } from './fields/labelOfField';
export { type NumberDisplay, numberDisplay } from './fields/NumberDisplay';
export {
  joinColour,
  type ScreenColour,
  sharedColour,
  splitColour,
  withIntensity,
  withScreenColour,
} from './fields/screenColour';
export {
  type NumberEdit,
  type NumberProblem,
  type NumberRange,
  readNumber,
  readNumberInRange,
} from './fields/readNumber';
export { valueText } from './fields/valueText';
export { roundToStep } from './fields/roundToStep';
export { stepOf } from './fields/stepOf';

export { dragLabel } from './gizmo/dragLabel';
export { nearestEuler } from './gizmo/nearestEuler';
export { type PoseValues, roundPose } from './gizmo/roundPose';
export {
  type DragOptions,
  type DragStart,
  placePivot,
  type Pose,
  TransformDrag,
  type TransformMode,
} from './gizmo/TransformDrag';
export { isComposing } from './keys/isComposing';
export { isTyping } from './keys/isTyping';
export { latinKey } from './keys/latinKey';

export { formatCount } from './language/formatCount';
export { formatTime } from './language/formatTime';
export { firstLanguage, type Language, languages } from './language/languages';
export { showPageLanguage, startPageLanguage } from './language/pageLanguage';
export { setTexts, t, tCount, textLanguage, textLocale, type Texts } from './language/translate';
