import { t } from './language/translate';

/** Common name of objects: 'chest', or '3 objects'. @param objects - at least one; nameless ones are named by type */
export function namesOf(objects: readonly { readonly name: string; readonly type?: string }[]): string {
  if (objects.length !== 1) return t('{count} objects', { count: objects.length });
  const [{ name, type = t('object') }] = objects;
  return name || type;
}

/**
 * Label such as 'Deleted chest' or 'Deleted 3 objects', in the current language.
 * @param verb - translated verb: `t('Deleted')`
 * @param objects - at least one; a nameless one is called by its type
 */
export function countLabel(
  verb: string,
  objects: readonly { readonly name: string; readonly type?: string }[],
): string {
  if (objects.length !== 1) return t('{verb} {count} objects', { verb, count: objects.length });
  return t('{verb} {name}', { verb, name: namesOf(objects) });
}
