import type { ComponentClass } from './ComponentClass';

/** Component classes made by scripts: a component that throws is switched off until the scene is reset. */
export const scriptClasses = new WeakSet<ComponentClass>();
