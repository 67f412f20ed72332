import { addToNumber, formatNumber, isComposing, readNumberInRange, stepFactor, t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useId, useLayoutEffect, useRef, useState } from 'react';
import { leaveField } from './leaveField';
import { Slider } from './Slider';
import { useScrub } from './useScrub';

export interface NumberInputProps {
  /** Value shown; null when the edited objects have different ones. */
  readonly value: number | null;
  readonly min?: number;
  readonly max?: number;
  /** Increment of an arrow key, or of a pixel while scrubbing; ten times with Shift, a tenth with Alt. */
  readonly step: number;
  /** Unit shown after the number, and assumed for numbers typed without one. */
  readonly unit?: string;
  /** Maximum number of decimals: three for 'short'; for 'long' five, or fewer by `step` while not focused. */
  readonly digits?: 'long' | 'short';
  readonly label: string;
  readonly description?: string;
  /** Element that can be dragged to change the number. */
  readonly handle?: ReactNode;
  /** Whether the label of the surrounding field can be dragged too. */
  readonly scrubsLabel?: boolean;
  /** Whether a slider is shown beside the number; requires `min` and `max`. */
  readonly slider?: boolean;
  readonly disabled?: boolean;
  onPreview(value: number): void;
  /** Previews a relative change of each value, such as '+=0.5'; `onPreview` is used when absent. */
  onPreviewEach?(update: (before: number) => number): void;
  /** Ends an edit, or takes it back; absent where previews are applied for good. */
  onCommit?(): void;
  onDiscard?(): void;
}

/** Text that is being typed into the number input, with the value before. */
interface Draft {
  readonly text: string;
  /** Value before typing. */
  readonly start: number | null;
  /** Why the text is not a number; '' while it is one, or may become one. */
  readonly problem: string;
}

/**
 * A number that can be typed, stepped by arrow keys, or scrubbed by dragging its handle, label or slider: previews,
 * then one commit. Enter commits, Escape discards; both leave the field, so that shortcuts work again. Text that is not
 * a number stays, with the reason below it.
 */
export function NumberInput(props: NumberInputProps): ReactNode {
  const { value, min, max, step, unit, label, description, handle, disabled, digits = 'long', slider } = props;
  const [draft, showDraft] = useState<Draft | null>(null);
  /** Latest draft, needed when the field is left before the next rendering. */
  const current = useRef<Draft | null>(null);
  const [hasFocus, setHasFocus] = useState(false);
  const problemId = useId();
  const input = useRef<HTMLInputElement>(null);
  const grip = useRef<HTMLSpanElement>(null);
  // selects the text only after the rendering that shows all decimals
  useLayoutEffect(() => {
    if (hasFocus) input.current?.select();
  }, [hasFocus]);
  /** Value at the beginning of the current edit; null when there is none. */
  const start = useRef<{ value: number | null } | null>(null);
  const scrubbed = useRef(0);

  // invalid text is replaced when the value changes elsewhere, as by an undo
  if (draft?.problem && value !== draft.start && !hasFocus) showDraft(null);

  const setDraft = (next: Draft | null): void => {
    current.current = next;
    showDraft(next);
  };
  const begin = (): { value: number | null } => (start.current ??= { value });
  const preview = (update: (before: number) => number, isRelative: boolean): void => {
    const { value: before } = begin();
    if (isRelative && props.onPreviewEach) props.onPreviewEach(update);
    else if (before !== null || !isRelative) props.onPreview(update(before ?? 0));
  };
  const add = (amount: number): void => {
    preview((before) => addToNumber(before, amount, { min, max, step }), true);
  };
  const commit = (): void => {
    if (!start.current) return;
    start.current = null;
    props.onCommit?.();
  };
  const discard = (): void => {
    if (!start.current) return;
    start.current = null;
    props.onDiscard?.();
  };

  const type = (text: string): void => {
    const before = current.current ? current.current.start : value;
    const read = readNumberInRange(text, { unit, min, max });
    const isWrong = read.problem !== null && !read.isIncomplete;
    setDraft({ text, start: before, problem: isWrong ? read.problem : '' });
    if (read.problem === null) preview(read.valueFor, read.isRelative);
    else if (isWrong || text.trim() === '') discard();
  };
  /** Commits the typed text. @returns whether no invalid text is left */
  const takeOver = (): boolean => {
    const { current: typed } = current;
    if (!typed) {
      commit();
      return true;
    }
    const { problem } = readNumberInRange(typed.text, { unit, min, max });
    if (problem !== null && typed.text.trim() !== '') {
      discard();
      setDraft({ ...typed, problem });
      return false;
    }
    setDraft(null);
    if (problem === null) commit();
    else discard();
    return true;
  };
  const giveBack = (): void => {
    setDraft(null);
    discard();
  };
  const keyDown = (event: KeyboardEvent<HTMLInputElement>): void => {
    if (isComposing(event)) return;
    const { key } = event;
    if (key === 'Enter') {
      event.stopPropagation();
      if (takeOver()) leaveField(event.currentTarget);
    } else if (key === 'Escape') {
      event.stopPropagation();
      giveBack();
      leaveField(event.currentTarget);
    } else if (key === 'ArrowUp' || key === 'ArrowDown') {
      event.preventDefault();
      if (!takeOver()) return;
      begin();
      scrubbed.current += (key === 'ArrowUp' ? step : -step) * stepFactor(event);
      add(scrubbed.current);
    }
  };
  const keyUp = ({ key }: KeyboardEvent): void => {
    // macOS sends no keyup for arrow keys while Command is held
    const isEnd = key === 'Meta' ? scrubbed.current !== 0 : key === 'ArrowUp' || key === 'ArrowDown';
    if (!isEnd) return;
    scrubbed.current = 0;
    commit();
  };

  useScrub(
    () =>
      [
        grip.current,
        props.scrubsLabel ? grip.current?.closest('.field')?.querySelector('.field-name') : null,
      ] as (HTMLElement | null)[],
    {
      begin() {
        setDraft(null);
        scrubbed.current = 0;
        begin();
      },
      move(pixels, factor) {
        scrubbed.current += pixels * step * factor;
        add(scrubbed.current);
      },
      end(keeps) {
        scrubbed.current = 0;
        if (keeps) commit();
        else discard();
      },
      click: () => input.current?.focus(),
    },
    disabled,
  );

  const problem = draft?.problem ?? '';
  return (
    <>
      <div className={slider ? 'number with-slider' : 'number'}>
        {slider && min !== undefined && max !== undefined && (
          <Slider
            {...{ value, min, max, step, disabled }}
            onSlide={(next) => preview(() => next, false)}
            onEnd={(keeps) => (keeps ? commit() : discard())}
          />
        )}
        {handle !== undefined && (
          <span className="number-handle" ref={grip} aria-hidden="true">
            {handle}
          </span>
        )}
        <input
          ref={input}
          className="input"
          type="text"
          inputMode="decimal"
          autoComplete="off"
          spellCheck={false}
          value={draft?.text ?? (value === null ? '' : formatNumber(value, digits, hasFocus ? undefined : step))}
          placeholder={value === null ? '—' : undefined}
          disabled={disabled}
          aria-label={label}
          aria-description={description}
          aria-invalid={problem !== ''}
          aria-errormessage={problem === '' ? undefined : problemId}
          onChange={(event) => type(event.target.value)}
          onFocus={() => {
            setHasFocus(true);
            current.current = draft;
          }}
          onBlur={() => {
            setHasFocus(false);
            takeOver();
          }}
          onKeyDown={keyDown}
          onKeyUp={keyUp}
        />
        {unit && (
          <span className="unit" aria-hidden="true">
            {t(unit)}
          </span>
        )}
      </div>
      {problem !== '' && (
        <p className="number-problem" id={problemId} role="alert">
          {problem}
        </p>
      )}
    </>
  );
}
