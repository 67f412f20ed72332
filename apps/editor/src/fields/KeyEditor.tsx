import { t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useState } from 'react';
import { Icon } from '../ui/Icon';
import { SearchSelect, type SearchOption } from '../ui/SearchSelect';

interface KeyEditorProps {
  /** KeyboardEvent.code of the key; null when the edited objects have different ones. */
  readonly value: string | null;
  readonly label: string;
  readonly description?: string;
  readonly disabled?: boolean;
  onCommit(code: string): void;
}

const letters = Array.from({ length: 26 }, (_, i) => `Key${String.fromCharCode(65 + i)}`);
const digits = Array.from({ length: 10 }, (_, i) => `Digit${i}`);
const others = ['Space', 'Enter', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Tab', 'Backspace'];
const modifiers = ['ShiftLeft', 'ShiftRight', 'ControlLeft', 'ControlRight', 'AltLeft', 'AltRight'];
const codes = [...letters, ...digits, ...others, ...modifiers];

/** Display name of a key code: 'E' for 'KeyE', 'Arrow Up' for 'ArrowUp'. */
const nameOf = (code: string): string =>
  code === 'Space' ? t('Space') : code.replace(/^(Key|Digit)(?=.$)/, '').replaceAll(/([a-z])([A-Z\d])/g, '$1 $2');

/** Chooses a key by position on the keyboard: pressed, or from a list. */
export function KeyEditor({ value, label, description, disabled, onCommit }: KeyEditorProps): ReactNode {
  const [isListening, setListening] = useState(false);
  const options: SearchOption[] = codes.map((code) => ({ value: code, label: nameOf(code) }));
  if (value && !codes.includes(value)) options.push({ value, label: nameOf(value) });
  const keyDown = (event: KeyboardEvent): void => {
    if (!isListening) return;
    event.preventDefault();
    event.stopPropagation();
    setListening(false);
    if (event.key !== 'Escape') onCommit(event.code);
  };
  const listen = isListening ? t('Press the key; Escape cancels') : t('Press the key for {label}', { label });
  return (
    <div className="key-field">
      <SearchSelect
        {...{ value: value || null, options, label, description, disabled }}
        placeholder={value === null ? '—' : t('No key')}
        onChange={(code) => onCommit(code ?? '')}
      />
      <button
        type="button"
        className={`button small ${isListening ? 'listening' : ''}`}
        aria-label={listen}
        title={listen}
        aria-pressed={isListening}
        disabled={disabled}
        onClick={(event) => {
          event.currentTarget.focus();
          setListening(true);
        }}
        onKeyDown={keyDown}
        onBlur={() => setListening(false)}
      >
        {isListening ? <span>{t('Press…')}</span> : <Icon name="keyboard" size={14} />}
      </button>
    </div>
  );
}
