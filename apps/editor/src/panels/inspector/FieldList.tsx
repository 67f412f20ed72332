import { sharedValue } from '@farol/editing';
import { type Field, type FieldOwner, isFieldVisible, sameValue } from '@farol/engine/fields';
import type { ReactElement, ReactNode } from 'react';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { FieldGroup } from './FieldGroup';
import { FieldRow } from './FieldRow';
import { useLiveTexts } from './useLiveTexts';

/** The texts that a field can be chosen from, each on a line; null where any text goes. */
function choicesOf(owner: FieldOwner, field: Field): string | null {
  if (field.kind !== 'string' || field.choices === undefined) return null;
  const list = (owner as unknown as Readonly<Record<string, unknown>>)[field.choices];
  return Array.isArray(list) ? list.join('\n') : '';
}

interface FieldListProps {
  /** Memoised, at least one. */
  readonly owners: readonly FieldOwner[];
  /** These alone, in this order; all when absent. */
  readonly names?: readonly string[];
}

/** The fields of a component, or of several of one type, that matter at present. */
export function FieldList({ owners, names }: FieldListProps): ReactNode {
  useOwnersRevision(owners);
  const places = useLiveTexts(owners.length === 1 ? owners[0] : null);
  const [owner] = owners;
  const rows = (names ?? Object.keys(owner.fields))
    .filter((name) => isFieldVisible(owner.fields, name, (other) => owner.getAuthored(other)))
    .map((name) => {
      const field = owner.fields[name];
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
          choices={choicesOf(owner, field)}
        />
      );
    });
  return inGroups(owner, rows);
}

/** Fields that name a group stand together, below its title, where the first of them stands. */
function inGroups(owner: FieldOwner, rows: readonly ReactElement[]): ReactNode {
  const groupOf = ({ key }: ReactElement): string | undefined => owner.fields[key!].group;
  return rows.map((row) => {
    const group = groupOf(row);
    if (group === undefined) return row;
    const members = rows.filter((each) => groupOf(each) === group);
    if (members[0] !== row) return null;
    return (
      <FieldGroup key={`group ${group}`} id={`${owner.ownerName}/${group}`} title={group}>
        {members}
      </FieldGroup>
    );
  });
}
