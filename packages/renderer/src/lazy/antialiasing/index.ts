export { SmoothEdges } from './SmoothEdges';
