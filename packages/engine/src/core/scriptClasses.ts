import type { ComponentClass } from './ComponentClass';

/** Classes that scripts of scenes have made: a component of theirs that throws is switched off until the scene is reset. */
export const scriptClasses = new WeakSet<ComponentClass>();
