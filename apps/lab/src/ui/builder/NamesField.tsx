import { t } from '@farol/editing';
import type { LightKindWords } from '../../plan/lightKinds';

interface NamesFieldProps {
  label: string;
  /** Texts of the options, by index. */
  words: readonly LightKindWords[];
  /** Indices of the chosen options, ascending. */
  values: readonly number[];
  onChange(values: readonly number[]): void;
}

/** A checkbox for each value of an axis of names. The last chosen value cannot be unchecked. */
export function NamesField({ label, words, values, onChange }: NamesFieldProps) {
  const choose = (index: number, isOn: boolean): void => {
    const next = isOn ? [...values, index].sort((a, b) => a - b) : values.filter((value) => value !== index);
    if (next.length > 0) onChange(next);
  };
  return (
    <fieldset class="names wide">
      <legend>{label}</legend>
      <ul class="boxes">
        {words.map(({ label: name, help }, index) => (
          <li key={name}>
            <label class="check" title={t(help)}>
              <input
                type="checkbox"
                checked={values.includes(index)}
                disabled={values.length === 1 && values[0] === index}
                onChange={({ currentTarget }) => choose(index, currentTarget.checked)}
              />
              {t(name)}
            </label>
          </li>
        ))}
      </ul>
    </fieldset>
  );
}
