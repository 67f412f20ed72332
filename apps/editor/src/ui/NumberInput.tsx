import { NumberField } from '@base-ui/react/number-field';
import { shownDecimals, t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useRef } from 'react';

export interface NumberInputProps {
  /** Null where several values differ. */
  readonly value: number | null;
  readonly min?: number;
  readonly max?: number;
  /** What an arrow key, or a pixel of a scrub, adds; ten times that with Shift, a tenth with Alt. */
  readonly step: number;
  /** Shown after the number. */
  readonly unit?: string;
  /** How many decimals are shown: five, or three where there is little room. */
  readonly digits?: 'long' | 'short';
  /** Accessible name. */
  readonly label: string;
  readonly description?: string;
  /** What can be dragged to change the number. */
  readonly handle?: ReactNode;
  readonly disabled?: boolean;
  onPreview(value: number): void;
  onCommit(): void;
  onDiscard(): void;
}

/** The number itself keeps all its digits. */
const formatOf = (digits: number): Intl.NumberFormatOptions => ({ maximumFractionDigits: digits, useGrouping: false });
const formats = { long: formatOf(shownDecimals.long), short: formatOf(shownDecimals.short) };

/**
 * A number that can be typed, stepped by arrow keys, and scrubbed by dragging its handle: many previews, one commit.
 * Enter takes a typed number, Escape goes back.
 */
export function NumberInput(props: NumberInputProps): ReactNode {
  const { value, min, max, step, unit, label, description, handle, disabled, digits = 'long' } = props;
  /** Whether text was typed since the field got the focus, and whether it shall be let go. */
  const typed = useRef(false);
  const dropped = useRef(false);

  const keyDown = (event: KeyboardEvent<HTMLInputElement>): void => {
    const input = event.currentTarget;
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.stopPropagation();
    dropped.current = event.key === 'Escape';
    input.blur();
    if (dropped.current) props.onDiscard();
    dropped.current = false;
    input.focus();
    input.select();
  };

  return (
    <NumberField.Root
      className="number"
      value={value}
      min={min}
      max={max}
      step={step}
      largeStep={step * 10}
      smallStep={step / 10}
      format={formats[digits]}
      locale="en-US"
      disabled={disabled}
      onValueChange={(next, details) => {
        const { reason } = details;
        if (reason === 'input-change' || reason === 'input-paste' || reason === 'input-clear') typed.current = true;
        // text that nobody has changed says less than the number does: its last digits are not shown
        if (dropped.current || (reason === 'input-blur' && !typed.current)) details.cancel();
        else if (next !== null) props.onPreview(next);
      }}
      onValueCommitted={(next) => {
        typed.current = false;
        if (dropped.current) return;
        if (next === null) props.onDiscard();
        else props.onCommit();
      }}
    >
      {handle !== undefined && (
        <NumberField.ScrubArea className="number-handle" pixelSensitivity={1}>
          {handle}
          <NumberField.ScrubAreaCursor className="scrub-cursor">
            <svg width="22" height="12" viewBox="0 0 22 12" aria-hidden="true">
              <path d="M6 1 1 6l5 5M16 1l5 5-5 5M1 6h20" fill="none" stroke="#000" strokeWidth="3.5" />
              <path d="M6 1 1 6l5 5M16 1l5 5-5 5M1 6h20" fill="none" stroke="#fff" strokeWidth="1.5" />
            </svg>
          </NumberField.ScrubAreaCursor>
        </NumberField.ScrubArea>
      )}
      <NumberField.Input
        className="input"
        aria-label={label}
        aria-description={description}
        data-numeric=""
        placeholder={value === null ? '—' : undefined}
        onKeyDown={keyDown}
        onFocus={(event) => {
          typed.current = false;
          event.currentTarget.select();
        }}
      />
      {unit && (
        <span className="unit" aria-hidden="true">
          {t(unit)}
        </span>
      )}
    </NumberField.Root>
  );
}
