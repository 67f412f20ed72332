import { sharedValue } from '@farol/editing';
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
      const { value, mixed, parts } = sharedValue(owners.map((each) => each.getAuthored(name)));
      return (
        <FieldRow
          key={name}
          owners={owners}
          name={name}
          field={field}
          value={value}
          mixed={mixed}
          parts={parts ? JSON.stringify(parts) : ''}
          isDefault={!mixed && sameValue(value, field.default)}
          places={places}
        />
      );
    });
}
