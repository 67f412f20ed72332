import { t } from '@farol/editing';

/** The name of a type of component in words, 'Object Renderer', in the language that is shown. */
export const componentName = (typeName: string): string => t(typeName.replaceAll(/([a-z])([A-Z])/g, '$1 $2'));
