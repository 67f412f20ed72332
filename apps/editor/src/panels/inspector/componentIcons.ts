import { type IconName, iconPaths } from '../../style/iconPaths';

/** Icon of a component type; a plain one for an unknown name. */
export const componentIcon = ({ icon }: { readonly icon: string }): IconName =>
  Object.hasOwn(iconPaths, icon) ? (icon as IconName) : 'object';

export { componentName as wordsOf } from '../../model/componentName';
