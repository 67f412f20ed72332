import { type KeyboardEvent, type ReactNode, useState } from 'react';

interface TextInputProps {
  /** Null where several values differ. */
  readonly value: string | null;
  /** Accessible name. */
  readonly label: string;
  readonly description?: string;
  readonly disabled?: boolean;
  onCommit(value: string): void;
}

/** Text that counts once Enter is pressed or the field is left; Escape goes back. */
export function TextInput({ value, label, description, disabled, onCommit }: TextInputProps): ReactNode {
  /** What is being typed; null while nothing is. */
  const [draft, setDraft] = useState<string | null>(null);

  const commit = (): void => {
    setDraft(null);
    if (draft !== null && draft !== value) onCommit(draft);
  };
  const keyDown = (event: KeyboardEvent): void => {
    if (event.key === 'Enter') commit();
    else if (event.key === 'Escape') setDraft(null);
    else return;
    event.stopPropagation();
  };

  return (
    <input
      className="input"
      type="text"
      value={draft ?? value ?? ''}
      placeholder={value === null ? '—' : undefined}
      aria-label={label}
      aria-description={description}
      disabled={disabled}
      autoComplete="off"
      spellCheck={false}
      onChange={(event) => setDraft(event.target.value)}
      onBlur={commit}
      onKeyDown={keyDown}
    />
  );
}
