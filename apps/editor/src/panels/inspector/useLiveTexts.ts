import { t, toDegrees } from '@farol/editing';
import { type FieldOwner, type FieldValue, isTriple, sameValue } from '@farol/engine/fields';
import { useEffect, useState } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { keysText } from '../../ui/keysText';

/** Interval between readings of simulated values (ms). */
const INTERVAL = 100;

function liveText(value: FieldValue, isAngle: boolean): string {
  if (!isTriple(value)) return Array.isArray(value) ? keysText(value) : String(value);
  return value.map((each) => (isAngle ? toDegrees(each) : each).toFixed(2)).join('  ');
}

/**
 * Shows the simulated value beside each field, several times per second while the scene plays. Writes to the DOM
 * directly, without rendering.
 * @param owner - null for none
 * @returns the elements to write to, by field; each field adds its own
 */
export function useLiveTexts(owner: FieldOwner | null): Map<string, HTMLElement> {
  const { simulation } = useEditor().document;
  const revision = useSignal(simulation.changed);
  const [places] = useState(() => new Map<string, HTMLElement>());
  const { isPlaying, state } = simulation;
  useEffect(() => {
    if (!owner) return;
    const write = (): void => {
      for (const [name, place] of places) {
        const value = state === 'stopped' ? null : owner.get(name);
        const text =
          state === 'stopped' || sameValue(value, owner.getAuthored(name))
            ? ''
            : t('now {value}', { value: liveText(value, owner.fields[name].kind === 'euler') });
        // only the text node changes, since replacing elements would recalculate styles
        const node = place.firstChild as Text | null;
        if ((node?.data ?? '') === text) continue;
        if (node) node.data = text;
        else place.textContent = text;
        if (place.hidden !== (text === '')) place.hidden = text === '';
      }
    };
    write();
    if (!isPlaying) return;
    const timer = setInterval(write, INTERVAL);
    return () => clearInterval(timer);
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- single steps while paused change values too
  }, [owner, places, state, isPlaying, revision]);
  return places;
}
