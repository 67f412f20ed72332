import { ComponentRegistry } from './ComponentRegistry';

/**
 * The types of components that a scene knows where it was given no others; `components/index.ts` registers them. For more
 * make `new ComponentRegistry([...builtinComponents.types.values(), Own])`.
 */
export const builtinComponents = new ComponentRegistry();
