import { t } from '@farol/editing';

/** Display name of a component type, 'Object Renderer', in the user's language. */
export const componentName = (typeName: string): string => t(typeName.replaceAll(/([a-z])([A-Z])/g, '$1 $2'));
