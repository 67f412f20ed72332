export { SMAA } from './SMAA';
export { TAA } from './TAA';
