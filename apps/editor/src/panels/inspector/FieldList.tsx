import { type FieldOwner, type FieldValue, isFieldVisible, sameValue } from '@farol/engine';
import { type ReactNode, useCallback } from 'react';
import { MathUtils } from 'three';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { usePoll } from '../../ui/usePoll';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { FieldRow } from './FieldRow';

/** How often moving values are read, a second. */
const LIVE_RATE = 10;

/** The fields of a component, or of several of one type, that matter at present. @param owners - memoised, at least one */
export function FieldList({ owners }: { owners: readonly FieldOwner[] }): ReactNode {
  useOwnersRevision(owners);
  const live = useLiveValues(owners[0]);
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
          live={owners.length === 1 ? (live[name] ?? null) : null}
        />
      );
    });
}

/** The coordinates of a vector that all owners have in common, null for the others; as JSON. */
function commonParts(owners: readonly FieldOwner[], name: string): string {
  const [first, ...others] = owners.map((owner) => owner.getAuthored(name) as readonly number[]);
  return JSON.stringify(first.map((value, i) => (others.every((other) => other[i] === value) ? value : null)));
}

/** The values of one owner that simulation has taken elsewhere, as text; read some times a second while it plays. */
function useLiveValues(owner: FieldOwner): Readonly<Record<string, string>> {
  const { simulation } = useEditor().document;
  useSignal(simulation.changed);
  const read = useCallback(() => {
    if (simulation.state === 'stopped') return '{}';
    const values: Record<string, string> = {};
    for (const [name, field] of Object.entries(owner.fields)) {
      const value = owner.get(name);
      if (!sameValue(value, owner.getAuthored(name))) values[name] = liveText(value, field.kind === 'euler');
    }
    return JSON.stringify(values);
  }, [owner, simulation]);
  return JSON.parse(usePoll(read, simulation.isPlaying ? LIVE_RATE : 0)) as Record<string, string>;
}

function liveText(value: FieldValue, isAngle: boolean): string {
  if (!Array.isArray(value)) return String(value);
  return value.map((each: number) => (isAngle ? each * MathUtils.RAD2DEG : each).toFixed(2)).join('  ');
}
