export { clearLearnt, learntChoices } from './learners';
export { LearningFrames } from './LearningFrames';
export type { LearntChoice } from './TechniqueLearner';
