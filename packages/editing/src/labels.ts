import { t } from './language/translate';

/**
 * 'Delete chest', or 'Delete 3 objects', in the language that is shown.
 * @param verb - in that language: `t('Delete')`
 * @param objects - at least one; one without a name goes by its type
 */
export function countLabel(
  verb: string,
  objects: readonly { readonly name: string; readonly type?: string }[],
): string {
  const [{ name, type = t('object') }] = objects;
  if (objects.length === 1) return t('{verb} {name}', { verb, name: name || type });
  return t('{verb} {count} objects', { verb, count: objects.length });
}

/** The label of a step within a sentence: 'Undo ' and 'delete chest'. */
export const lowerFirst = (label: string): string => label.charAt(0).toLowerCase() + label.slice(1);
