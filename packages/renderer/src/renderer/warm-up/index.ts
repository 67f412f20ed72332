export { addLazyMicroShaders } from './addLazyMicroShaders';
export { compileByDrawing } from './compileByDrawing';
export { WarmUp } from './WarmUp';
export { whenReady } from './whenReady';
