import type { LightKindWords } from '../../plan/lightKinds';

interface NamesFieldProps {
  label: string;
  /** What can be chosen, in the order of their places. */
  words: readonly LightKindWords[];
  /** Places of the chosen ones, ascending. */
  values: readonly number[];
  onChange(values: readonly number[]): void;
}

/** Values of a series that are names: a box each. The last one stays. */
export function NamesField({ label, words, values, onChange }: NamesFieldProps) {
  const choose = (place: number, isOn: boolean): void => {
    const next = isOn ? [...values, place].sort((a, b) => a - b) : values.filter((value) => value !== place);
    if (next.length > 0) onChange(next);
  };
  return (
    <fieldset class="names wide">
      <legend>{label}</legend>
      <ul class="boxes">
        {words.map(({ label: name, help }, place) => (
          <li key={name}>
            <label class="check" title={help}>
              <input
                type="checkbox"
                checked={values.includes(place)}
                disabled={values.length === 1 && values[0] === place}
                onChange={({ currentTarget }) => choose(place, currentTarget.checked)}
              />
              {name}
            </label>
          </li>
        ))}
      </ul>
    </fieldset>
  );
}
