import { t } from '@farol/editing';
import {
  type CSSProperties,
  type KeyboardEvent,
  type ReactNode,
  useEffect,
  useLayoutEffect,
  useRef,
  useState,
} from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { tourSteps } from './tourSteps';
import './tour.css';
import { Button } from '../../ui/Button';

/** Distance between a control and the card (CSS pixels). */
const GAP = 12;

/** Rectangle of the first visible match of a selector; null when there is none. */
function shownOf(selector: string): DOMRect | null {
  for (const element of document.querySelectorAll(selector)) {
    const box = element.getBoundingClientRect();
    if (box.width > 0 && box.height > 0) return box;
  }
  return null;
}

/** Position of a card beside a control, within the window. */
function placeBeside(box: DOMRect | null, width: number, height: number): CSSProperties {
  const within = (at: number, size: number, all: number): number => Math.max(8, Math.min(at, all - size - 8));
  if (!box) return { left: (innerWidth - width) / 2, top: (innerHeight - height) / 2 };
  const left = within(box.left + box.width / 2 - width / 2, width, innerWidth);
  if (box.bottom + GAP + height <= innerHeight) return { left, top: box.bottom + GAP };
  if (box.top - GAP - height >= 0) return { left, top: box.top - GAP - height };
  const top = within(box.top + GAP, height, innerHeight);
  if (box.right + GAP + width <= innerWidth) return { left: box.right + GAP, top };
  if (box.left - GAP - width >= 0) return { left: box.left - GAP - width, top };
  // the control fills the window: the card lies over it, at the bottom
  return { left, top: innerHeight - height - GAP };
}

/** Tour that points at controls, which remain usable. Escape or its button ends it. */
export function Tour(): ReactNode {
  const { tour } = useEditor();
  useSignal(tour.changed);
  const { current } = tour;
  return current === null ? null : <Step key={current} current={current} />;
}

function Step({ current }: { current: number }): ReactNode {
  const { tour, layout } = useEditor();
  const steps = tourSteps();
  const { panel, target, title, text } = steps[current];
  const card = useRef<HTMLDivElement>(null);
  const [box, setBox] = useState<DOMRect | null>(null);
  const [place, setPlace] = useState<CSSProperties>({});

  useEffect(() => {
    if (panel) layout.open(panel);
    card.current?.focus();
  }, [layout, panel]);

  useLayoutEffect(() => {
    let frame = 0;
    let last = '';
    // the control is followed in each frame, since it moves as panels load and the window changes
    const follow = (): void => {
      frame = requestAnimationFrame(follow);
      const { offsetWidth, offsetHeight } = card.current!;
      const found = shownOf(target);
      const key = [found?.x, found?.y, found?.width, found?.height, offsetHeight, innerWidth, innerHeight].join();
      if (key === last) return;
      last = key;
      setBox(found);
      setPlace(placeBeside(found, offsetWidth, offsetHeight));
    };
    follow();
    return () => cancelAnimationFrame(frame);
  }, [target]);

  const isLast = current === steps.length - 1;
  const next = (): void => tour.show(isLast ? null : current + 1);
  const keyDown = (event: KeyboardEvent): void => {
    if (event.key === 'Escape') tour.show(null);
    else if (event.key === 'ArrowRight') next();
    else if (event.key === 'ArrowLeft' && current > 0) tour.show(current - 1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <>
      {box && (
        <div
          className="tour-mark"
          style={{ left: box.left - 4, top: box.top - 4, width: box.width + 8, height: box.height + 8 }}
        />
      )}
      <div
        ref={card}
        className="tour-card"
        role="dialog"
        aria-labelledby="tour-title"
        aria-describedby="tour-text"
        tabIndex={-1}
        style={place}
        onKeyDown={keyDown}
      >
        <h2 id="tour-title">{title}</h2>
        <p id="tour-text">{text}</p>
        <div className="tour-buttons">
          <Button label={t('Leave the tour')} onClick={() => tour.show(null)} />
          <span className="dim">{t('{step} of {steps}', { step: current + 1, steps: steps.length })}</span>
          <Button label={t('Back')} disabled={current === 0} onClick={() => tour.show(current - 1)} />
          <Button look="primary" label={isLast ? t('Done') : t('Next')} onClick={next} />
        </div>
      </div>
    </>
  );
}
