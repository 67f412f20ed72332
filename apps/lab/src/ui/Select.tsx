import { useId } from 'preact/hooks';

interface SelectProps {
  label: string;
  value: string;
  options: readonly (readonly [value: string, label: string])[];
  /** CSS class; 'field', with the label above, when absent. */
  class?: string;
  onChange(value: string): void;
}

/** A select with its label. */
export function Select({ label, value, options, class: className = 'field', onChange }: SelectProps) {
  const id = useId();
  return (
    <div class={className}>
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={({ currentTarget }) => onChange(currentTarget.value)}>
        {options.map(([key, text]) => (
          <option key={key} value={key}>
            {text}
          </option>
        ))}
      </select>
    </div>
  );
}
