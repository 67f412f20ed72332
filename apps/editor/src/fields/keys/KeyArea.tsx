import { type CSSProperties, type KeyboardEvent, type PointerEvent, type ReactNode, useEffect, useRef } from 'react';

/** Position and labels of a key in the area. */
export interface ShownKey {
  /** Horizontal position, from 0 (left) to 1 (right). */
  readonly x: number;
  /** Vertical position, from 0 (bottom) to 1 (top); centred when absent. */
  readonly y?: number;
  /** Accessible name of the control. */
  readonly label: string;
  /** Value of the selected key as text, for screen readers. */
  readonly valueText: string;
  readonly style?: CSSProperties;
}

interface KeyAreaProps {
  readonly className: string;
  /** Accessible name of the control. */
  readonly label: string;
  readonly description: string;
  readonly keys: readonly ShownKey[];
  readonly selected: number;
  /** Graph or gradient behind the keys. */
  readonly children?: ReactNode;
  onSelect(index: number): void;
  /** Called when empty space is pressed, at a position from 0 to 1; a drag may follow. */
  onAdd(x: number, y: number): void;
  onDrag(x: number, y: number): void;
  onEnd(keeps: boolean): void;
  /** Called for an arrow key, with numbers of steps to the right and up. */
  onNudge(right: number, up: number): void;
  onRemove(index: number): void;
}

/** Longest time between the presses of a double click (ms). */
const DOUBLE_CLICK = 500;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowDown: [0, -1],
  ArrowUp: [0, 1],
};

const keyOf = (target: EventTarget): number | null => {
  const element = (target as Element).closest<HTMLElement>('[data-key]');
  return element ? Number(element.dataset.key) : null;
};

/**
 * Area with keys: a click adds one, dragging moves it, a double click removes it. With the keyboard, Tab reaches each
 * key, arrow keys move it (ten times as far with Shift) and Delete removes it.
 */
export function KeyArea(props: KeyAreaProps): ReactNode {
  const { keys, selected } = props;
  const area = useRef<HTMLDivElement>(null);
  /** Offset from the pointer to the centre of the dragged key (shares of the area); null when none is dragged. */
  const grab = useRef<{ readonly x: number; readonly y: number; isMoved: boolean } | null>(null);
  const addedAt = useRef(-Infinity);
  /** Whether the selected key gets the focus after the next rendering. */
  const wantsFocus = useRef(false);
  const isNudging = useRef(false);

  useEffect(() => {
    if (!wantsFocus.current) return;
    wantsFocus.current = false;
    area.current?.querySelector<HTMLElement>(`[data-key="${selected}"]`)?.focus();
  });

  const placeOf = ({ clientX, clientY }: PointerEvent): readonly [number, number] => {
    const { left, top, width, height } = area.current!.getBoundingClientRect();
    return [(clientX - left) / width, 1 - (clientY - top) / height];
  };
  const press = (event: PointerEvent<HTMLDivElement>): void => {
    if (event.button !== 0) return;
    event.preventDefault();
    area.current!.setPointerCapture(event.pointerId);
    wantsFocus.current = true;
    const [x, y] = placeOf(event);
    const index = keyOf(event.target);
    if (index === null) {
      grab.current = { x: 0, y: 0, isMoved: true };
      addedAt.current = event.timeStamp;
      props.onAdd(x, y);
      return;
    }
    grab.current = { x: keys[index].x - x, y: (keys[index].y ?? y) - y, isMoved: false };
    props.onSelect(index);
    (event.target as Element).closest<HTMLElement>('[data-key]')!.focus();
  };
  const move = (event: PointerEvent<HTMLDivElement>): void => {
    const { current: start } = grab;
    if (!start || (!start.isMoved && event.movementX === 0 && event.movementY === 0)) return;
    start.isMoved = true;
    const [x, y] = placeOf(event);
    wantsFocus.current = true;
    props.onDrag(x + start.x, y + start.y);
  };
  const end = (keeps: boolean): void => {
    if (!grab.current) return;
    grab.current = null;
    props.onEnd(keeps);
  };
  const endNudge = (): void => {
    if (!isNudging.current) return;
    isNudging.current = false;
    props.onEnd(true);
  };
  const keyDown = (event: KeyboardEvent<HTMLDivElement>): void => {
    const index = keyOf(event.target);
    const { key, shiftKey } = event;
    if (key === 'Escape' && grab.current) end(false);
    else if (index === null) return;
    else if (key === 'Delete' || key === 'Backspace') {
      wantsFocus.current = true;
      props.onRemove(index);
    } else if (key in ARROWS) {
      const [right, up] = ARROWS[key];
      const factor = shiftKey ? 10 : 1;
      isNudging.current = true;
      wantsFocus.current = true;
      props.onNudge(right * factor, up * factor);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <div
      ref={area}
      className={`key-area ${props.className}`}
      role="group"
      aria-label={props.label}
      aria-description={props.description}
      onPointerDown={press}
      onPointerMove={move}
      onPointerUp={() => end(true)}
      onPointerCancel={() => end(false)}
      onLostPointerCapture={() => end(true)}
      onDoubleClick={(event) => {
        const index = keyOf(event.target);
        if (index !== null && event.timeStamp - addedAt.current > DOUBLE_CLICK) props.onRemove(index);
      }}
      onKeyDown={keyDown}
      onKeyUp={({ key }) => (key in ARROWS || key === 'Meta') && endNudge()}
      onBlur={(event) => !event.currentTarget.contains(event.relatedTarget) && endNudge()}
    >
      {props.children}
      {keys.map(({ x, y, label, valueText, style }, i) => (
        <div
          key={i}
          className="key-point"
          role="slider"
          tabIndex={0}
          data-key={i}
          data-selected={i === selected}
          aria-label={label}
          aria-valuemin={0}
          aria-valuemax={1}
          aria-valuenow={x}
          aria-valuetext={valueText}
          style={{ ...style, left: `${x * 100}%`, bottom: y === undefined ? undefined : `${y * 100}%` }}
          onFocus={() => props.onSelect(i)}
        />
      ))}
    </div>
  );
}
