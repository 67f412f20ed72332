import { type FieldOwner, isFieldVisible, sameValue } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { FieldRow } from './FieldRow';
import { useLiveTexts } from './useLiveTexts';

/** The fields of a component, or of several of one type, that matter at present. @param owners - memoised, at least one */
export function FieldList({ owners }: { owners: readonly FieldOwner[] }): ReactNode {
  useOwnersRevision(owners);
  const places = useLiveTexts(owners.length === 1 ? owners[0] : null);
  const [owner] = owners;
  return Object.entries(owner.fields)
    .filter(([name]) => isFieldVisible(owner.fields, name, (other) => owner.getAuthored(other)))
    .map(([name, field]) => {
      const value = owner.getAuthored(name);
      const mixed = owners.some((other) => !sameValue(other.getAuthored(name), value));
      return (
        <FieldRow
          key={name}
          owners={owners}
          name={name}
          field={field}
          value={mixed ? null : value}
          mixed={mixed}
          parts={mixed && Array.isArray(value) ? commonParts(owners, name) : ''}
          isDefault={!mixed && sameValue(value, field.default)}
          places={places}
        />
      );
    });
}

/** The coordinates of a vector that all owners have in common, null for the others; as JSON. */
function commonParts(owners: readonly FieldOwner[], name: string): string {
  const [first, ...others] = owners.map((owner) => owner.getAuthored(name) as readonly number[]);
  return JSON.stringify(first.map((value, i) => (others.every((other) => other[i] === value) ? value : null)));
}
