export { GpuTimer } from './GpuTimer';
