export { type BakedSurroundings, LightProbes, setBakedSurroundings } from './LightProbes';
export { probePoints, type ProbeBox } from './ProbeBox';
export { ProbeGrid } from './ProbeGrid';
