import { type Command, fieldInUnit } from '@farol/editing';
import { Component } from '@farol/engine';
import { type Field, type FieldOwner, isFieldVisible, sameValue, variantOfField } from '@farol/engine/fields';
import { type ReactElement, type ReactNode, useMemo } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { FieldGroup } from './FieldGroup';
import { allAtDefault, isAtDefault } from './atDefault';
import { FieldRow } from './FieldRow';
import { SharedValues } from './SharedValues';
import { useLiveTexts } from './useLiveTexts';

/**
 * Group of the fields of an object's own material. Folded, since materials are edited as assets, unless the last step
 * added the object: its colour is likely edited next.
 */
const OWN_MATERIAL = 'Own material';

/** Choices of a text field, one per line; null when it takes any text. */
function choicesOf(owner: FieldOwner, field: Field): string | null {
  if (field.kind !== 'string' || field.choices === undefined) return null;
  const list = (owner as unknown as Readonly<Record<string, unknown>>)[field.choices];
  return Array.isArray(list) ? list.join('\n') : '';
}

/** Field to show for all owners, without its unit when units differ (lights of several types). */
function shownField(owners: readonly FieldOwner[], name: string): Field {
  const [first, ...others] = owners.map((owner) =>
    variantOfField(owner.fields[name], (other) => owner.getAuthored(other)),
  );
  return others.every((field) => field === first) ? first : owners[0].fields[name];
}

interface FieldListProps {
  /** Edited components or settings of one type, at least one; memoised. */
  readonly owners: readonly FieldOwner[];
  /** Names of the fields to show, in this order; all when absent. */
  readonly names?: readonly string[];
}

/** The relevant fields of a component, or of several of one type. */
export function FieldList({ owners, names }: FieldListProps): ReactNode {
  const { document, commands } = useEditor();
  const values = useMemo(() => new SharedValues(owners, document), [owners, document]);
  useOwnersRevision(owners, values.forget);
  useSignal(document.previewed);
  const places = useLiveTexts(owners.length === 1 ? owners[0] : null);
  const [owner] = owners;
  // uniforms of a surface are fields, and change with its text
  useSignal(document.assetsChanged);
  const rows = (names ?? Object.keys(owner.fields))
    .filter((name) => owners.every(({ fields }) => Object.hasOwn(fields, name)))
    .filter((name) => owner.fields[name].besideField === undefined)
    .filter((name) => isFieldVisible(owner.fields, name, (other) => owner.getAuthored(other)))
    .filter((name) => !owner.fields[name].deprecated || owners.some((each) => !isAtDefault(each, name)))
    .map((name) => {
      const field = fieldInUnit(shownField(owners, name), (other) => owners.map((each) => each.getAuthored(other)));
      const { value, mixed, parts } = values.of(name);
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
  return inGroups(owners, rows, isNew(owner, commands.last));
}

/** Whether a command added the object of a component. */
function isNew(owner: FieldOwner, made: Command | null): boolean {
  const id = owner instanceof Component ? owner.gameObject.id : '';
  return made?.selection?.done.includes(id) === true && !made.selection.undone.includes(id);
}

/**
 * Puts the fields of each group below its title, after fields without a group; a group at its defaults is folded.
 * @param isMade - whether the owners were just added
 */
function inGroups(owners: readonly FieldOwner[], rows: readonly ReactElement[], isMade: boolean): ReactNode {
  const [owner] = owners;
  const groupOf = ({ key }: ReactElement): string | undefined => owner.fields[key!].group;
  const groups = new Set(rows.map(groupOf));
  groups.delete(undefined);
  if (groups.size === 0) return rows;
  return [
    ...rows.filter((row) => groupOf(row) === undefined),
    ...[...groups].map((group) => {
      const grouped = rows.filter((row) => groupOf(row) === group);
      const names = grouped.map(({ key }) => key!);
      return (
        <FieldGroup
          key={`group ${group}`}
          id={`${owner.ownerName}/${group}`}
          title={group!}
          isFoldedAtFirst={() => (group === OWN_MATERIAL ? !isMade : owners.every((each) => allAtDefault(each, names)))}
        >
          {grouped}
        </FieldGroup>
      );
    }),
  ];
}
