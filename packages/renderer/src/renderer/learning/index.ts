export { clearLearnt } from './learners';
export { LearningFrames } from './LearningFrames';
