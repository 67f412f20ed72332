import { formatNumber, t } from '@farol/editing';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import { NumberInput } from '../../ui/NumberInput';
import { Slider } from '../../ui/Slider';

interface NumberCellProps {
  readonly value: number;
  readonly unit?: string;
  readonly min?: number;
  readonly max?: number;
  readonly step: number;
  /** Accessible name, such as 'Intensity of Lamp'. */
  readonly label: string;
  /** Maximum of the dimmer beside the number; 'own' computes it from the value. No dimmer when absent. */
  readonly dimmer?: number | 'own';
  readonly tabIndex: number;
  /** Previews a value that was dragged. @param start - value before the drag */
  onDim?(value: number, start: number): void;
  /** Previews a value that was typed. */
  onPreview(value: number): void;
  onCommit(): void;
  onDiscard(): void;
}

/** Maximum of a dimmer: the first of 1, 2, 5, 10, 20, … that exceeds the value by a quarter. */
function scaleOf(value: number): number {
  const wanted = Math.max(1, value * 1.25);
  const power = 10 ** Math.floor(Math.log10(wanted));
  return power * [1, 2, 5, 10].find((factor) => power * factor >= wanted)!;
}

/** A number beside a dimmer; a press turns the number into a text field. */
export function NumberCell(props: NumberCellProps): ReactNode {
  const { value, unit, min, max, step, label, dimmer, tabIndex, onDim, onPreview, onCommit, onDiscard } = props;
  const [isTyped, setTyped] = useState(false);
  /** Maximum of the dimmer and value at the start of a drag; null when none is dragged. */
  const [held, hold] = useState<{ readonly end: number; readonly start: number } | null>(null);
  const cell = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    if (isTyped) cell.current?.querySelector('input')?.focus();
  }, [isTyped]);
  const commit = useRef(onCommit);
  useEffect(() => {
    commit.current = onCommit;
  });
  // typed text is committed when the row is scrolled out of view
  useEffect(() => () => commit.current(), []);
  const end = dimmer === 'own' ? (held?.end ?? scaleOf(value)) : dimmer;
  return (
    <span className="lights-number" ref={cell}>
      {end !== undefined && (
        <Slider
          value={Math.min(value, end)}
          min={0}
          max={end}
          step={end / 200}
          onSlide={(next) => {
            const { start } = held ?? { start: value };
            hold({ end, start });
            onDim!(next, start);
          }}
          onEnd={(keeps) => {
            hold(null);
            if (keeps) onCommit();
            else onDiscard();
          }}
        />
      )}
      {isTyped ? (
        <span
          className="lights-input"
          onBlur={({ currentTarget, relatedTarget }) => {
            setTyped(false);
            if (!relatedTarget) currentTarget.closest<HTMLElement>('.lights-grid')?.focus({ preventScroll: true });
          }}
        >
          <NumberInput {...{ value, min, max, step, unit, label, onPreview, onCommit, onDiscard }} digits="short" />
        </span>
      ) : (
        <button
          type="button"
          className="lights-text"
          tabIndex={tabIndex}
          aria-label={`${label}: ${formatNumber(value, 'short')} ${unit ? t(unit) : ''}`}
          onClick={() => setTyped(true)}
        >
          {formatNumber(value, 'short')} {unit && <span className="dim">{t(unit)}</span>}
        </button>
      )}
    </span>
  );
}
