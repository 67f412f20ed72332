import { t } from '@farol/editing';
import type { IconName } from '../../style/iconPaths';

const icons: Readonly<Record<string, IconName>> = {
  Transform: 'transform',
  ObjectRenderer: 'mesh',
  ModelRenderer: 'mesh',
  Animator: 'play',
  Light: 'point',
  Camera: 'camera',
  Decal: 'decal',
  KeyController: 'keyboard',
  MouseController: 'mouse',
  RandomMovement: 'motion',
};

/** The icon of a type of component. */
export const componentIcon = (typeName: string): IconName => icons[typeName] ?? 'object';

/** The name of a type of component in words, 'Object Renderer', in the language that is shown. */
export const wordsOf = (typeName: string): string => t(typeName.replaceAll(/([a-z])([A-Z])/g, '$1 $2'));
