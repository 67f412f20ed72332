import { isComposing } from '@farol/editing';
import { leaveField } from './leaveField';
import { type KeyboardEvent, type ReactNode, useRef, useState } from 'react';

interface TextInputProps {
  /** Text shown; null when the edited objects have different ones. */
  readonly value: string | null;
  readonly label: string;
  readonly description?: string;
  readonly disabled?: boolean;
  onCommit(value: string): void;
}

/** A text field that commits on Enter or when it is left; Escape discards. Both keys leave the field. */
export function TextInput({ value, label, description, disabled, onCommit }: TextInputProps): ReactNode {
  /** Text that is being typed; null when there is none. */
  const [draft, showDraft] = useState<string | null>(null);
  /** Latest draft, needed when the field is left before the next rendering. */
  const current = useRef<string | null>(null);
  const setDraft = (next: string | null): void => {
    current.current = next;
    showDraft(next);
  };

  const commit = (): void => {
    const { current: typed } = current;
    setDraft(null);
    if (typed !== null && typed !== value) onCommit(typed);
  };
  const keyDown = (event: KeyboardEvent<HTMLInputElement>): void => {
    if (isComposing(event)) return;
    if (event.key === 'Enter') commit();
    else if (event.key === 'Escape') setDraft(null);
    else return;
    event.stopPropagation();
    leaveField(event.currentTarget);
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
      onFocus={(event) => event.currentTarget.select()}
      onBlur={commit}
      onKeyDown={keyDown}
    />
  );
}
