export { ScaledFrames } from './ScaledFrames';
