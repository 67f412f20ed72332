import { useEffect, useId, useState } from 'preact/hooks';
import { parseValues } from './parseValues';

interface ValuesFieldProps {
  label: string;
  values: readonly number[];
  /** Explanation of the values, below the field. */
  hint: string;
  onChange(values: readonly number[]): void;
}

/** Values of a series as text. An invalid text stays in the field, with the problem below, and is not reported. */
export function ValuesField({ label, values, hint, onChange }: ValuesFieldProps) {
  const id = useId();
  const [text, setText] = useState(() => values.join(', '));
  const parsed = parseValues(text);
  const problem = 'problem' in parsed ? parsed.problem : null;
  const key = values.join();
  useEffect(() => {
    // the text follows a change of the preset or the address
    setText((current) => (sameValues(current, key) ? current : key.replaceAll(',', ', ')));
  }, [key]);
  const read = (next: string): void => {
    setText(next);
    const result = parseValues(next);
    if ('values' in result && result.values.join() !== key) onChange(result.values);
  };
  return (
    <div class="field wide">
      <label for={id}>{label}</label>
      <input
        id={id}
        type="text"
        inputMode="text"
        autocomplete="off"
        spellcheck={false}
        value={text}
        aria-invalid={problem !== null}
        aria-describedby={`${id}-hint`}
        onInput={({ currentTarget }) => read(currentTarget.value)}
      />
      <p id={`${id}-hint`} class={problem ? 'problem' : 'hint'}>
        {problem ?? hint}
      </p>
    </div>
  );
}

function sameValues(text: string, key: string): boolean {
  const parsed = parseValues(text);
  return 'values' in parsed && parsed.values.join() === key;
}
