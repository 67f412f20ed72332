export { MultisampledEdges } from './MultisampledEdges';
export { SMAA } from './SMAA';
export { TAA } from './TAA';
