export { addLazyMicroShaders } from './addLazyMicroShaders';
export { compileByDrawing } from './compileByDrawing';
export { Overdraw } from './Overdraw';
export { figuresOf, TechniqueChooser } from './TechniqueChooser';
export { WarmUp } from './WarmUp';
export { whenReady } from './whenReady';
