import { ComponentRegistry } from './ComponentRegistry';

/**
 * Component types of scenes without a registry of their own; `components/index.ts` registers them. For more types, make
 * `new ComponentRegistry([...builtinComponents.types.values(), Own])`.
 */
export const builtinComponents = new ComponentRegistry();
