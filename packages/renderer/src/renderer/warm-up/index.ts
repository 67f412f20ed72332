export { addLazyMicroShaders } from './addLazyMicroShaders';
export { compileByDrawing } from './compileByDrawing';
export { Overdraw } from './Overdraw';
export { WarmUp } from './WarmUp';
export { whenReady } from './whenReady';
