export { addLazyMicroShaders } from './addLazyMicroShaders';
export { compileByDrawing } from './compileByDrawing';
export { Overdraw } from './Overdraw';
export { strictDraw } from '../../three/strictDraw';
export { figuresOf, TechniqueChooser } from './TechniqueChooser';
export { WarmUp } from './WarmUp';
export { whenReady } from './whenReady';
