import { t, formatCount } from '@farol/editing';
import { useEffect, useId, useState } from 'preact/hooks';

interface NumberFieldProps {
  label: string;
  value: number;
  min: number;
  max: number;
  unit?: string;
  isDisabled?: boolean;
  onChange(value: number): void;
}

/** Field for a whole number within bounds. A number out of bounds is marked as invalid and not reported. */
export function NumberField({ label, value, min, max, unit, isDisabled, onChange }: NumberFieldProps) {
  const id = useId();
  const [text, setText] = useState(String(value));
  useEffect(() => setText((current) => (Number(current) === value ? current : String(value))), [value]);
  const isValid = isWithin(text, min, max);
  const read = (next: string): void => {
    setText(next);
    if (isWithin(next, min, max) && Number(next) !== value) onChange(Number(next));
  };
  return (
    <div class="field">
      <label for={id}>
        {label}
        {unit && <span class="unit"> ({unit})</span>}
      </label>
      <input
        id={id}
        type="number"
        min={min}
        max={max}
        value={text}
        disabled={isDisabled}
        aria-invalid={!isValid}
        aria-describedby={isValid ? undefined : `${id}-problem`}
        onInput={({ currentTarget }) => read(currentTarget.value)}
      />
      {!isValid && (
        <p id={`${id}-problem`} class="problem">
          {t('From {min} to {max}, whole.', { min: formatCount(min), max: formatCount(max) })}
        </p>
      )}
    </div>
  );
}

function isWithin(text: string, min: number, max: number): boolean {
  const value = Number(text);
  return text.trim() !== '' && value >= min && value <= max && Number.isInteger(value);
}
