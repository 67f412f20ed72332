export { compileByDrawing } from './compileByDrawing';
export { WarmUp } from './WarmUp';
