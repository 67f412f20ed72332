import { valueOnSlider } from '@farol/editing';
import { type PointerEvent, type ReactNode, useRef } from 'react';

interface SliderProps {
  /** Value shown; null when the edited objects have different ones. */
  readonly value: number | null;
  readonly min: number;
  readonly max: number;
  /** Increment of the value; a tenth of it with Alt held. */
  readonly step: number;
  readonly disabled?: boolean;
  onSlide(value: number): void;
  /** Called at the end of a drag. @param keeps - whether its result is kept */
  onEnd(keeps: boolean): void;
}

/** A slider for pointers only; the number beside it handles keys. */
export function Slider({ value, min, max, step, disabled, onSlide, onEnd }: SliderProps): ReactNode {
  const isDown = useRef(false);
  const part = value === null ? null : (Math.min(Math.max(value, min), max) - min) / (max - min);

  const slide = (event: PointerEvent<HTMLDivElement>): void => {
    const { left, width } = event.currentTarget.getBoundingClientRect();
    onSlide(valueOnSlider((event.clientX - left) / width, { min, max, step }, event.altKey));
  };
  const end = (keeps: boolean) => (): void => {
    if (!isDown.current) return;
    isDown.current = false;
    onEnd(keeps);
  };

  return (
    <div
      className="slider"
      aria-hidden="true"
      data-disabled={disabled}
      onPointerDown={(event) => {
        if (disabled || event.button !== 0) return;
        event.preventDefault();
        (document.activeElement as HTMLElement | null)?.blur();
        event.currentTarget.setPointerCapture(event.pointerId);
        isDown.current = true;
        slide(event);
      }}
      onPointerMove={(event) => isDown.current && slide(event)}
      onPointerUp={end(true)}
      onPointerCancel={end(false)}
      onLostPointerCapture={end(true)}
    >
      <div className="slider-bar">
        {part !== null && <div className="slider-part" style={{ width: `${part * 100}%` }} />}
        {part !== null && <div className="slider-knob" style={{ left: `${part * 100}%` }} />}
      </div>
    </div>
  );
}
