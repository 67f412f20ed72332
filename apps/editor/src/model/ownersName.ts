import { namesOf, t } from '@farol/editing';
import type { Component, GameObject } from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';

const objectOf = (owner: FieldOwner): GameObject | null => {
  const component = owner as Partial<Component>;
  return component.isAttached ? (component.gameObject ?? null) : null;
};

/** Name of a field's owners for labels: the object's name, '3 objects', or 'Scene'. @param owners - at least one */
export function ownersName(owners: readonly FieldOwner[]): string {
  const objects = owners.flatMap((owner) => objectOf(owner) ?? []);
  return objects.length > 0 ? namesOf(objects) : t(owners[0].ownerName);
}
