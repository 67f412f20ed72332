export { WeightedBlendedOIT } from './WeightedBlendedOIT';
