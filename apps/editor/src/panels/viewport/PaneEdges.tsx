import { t } from '@farol/editing';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useSyncExternalStore } from 'react';
import { halfShare, LEAST_SHARE, limitShare, type PaneShare } from '../../viewport/panes/PaneShare';
import { useEditor } from '../../ui/EditorContext';

/** Step of an arrow key, as a share of the viewport. */
const STEP = 0.02;

const isSame = (a: PaneShare, b: PaneShare): boolean => a.x === b.x && a.y === b.y;

/** Dividers between four views: dragged, moved by arrow keys, and centred by a double click. */
export function PaneEdges(): ReactNode {
  const { viewport, preferences } = useEditor();
  const chosen = useSyncExternalStore(preferences.subscribe, () => preferences.getState().views.share ?? halfShare);
  const share = limitShare(chosen);
  const set = (next: PaneShare): void => {
    const limited = limitShare(next);
    if (!isSame(limited, share)) preferences.setState(({ views }) => ({ views: { ...views, share: limited } }));
  };
  const edge = (moves: 'x' | 'y' | 'both', label: string): ReactNode => {
    const [movesX, movesY] = [moves !== 'y', moves !== 'x'];
    const drag = (event: PointerEvent<HTMLDivElement>): void => {
      if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
      const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
      set({
        x: movesX ? (event.clientX - left) / width : share.x,
        y: movesY ? (event.clientY - top) / height : share.y,
      });
    };
    const keyDown = (event: KeyboardEvent): void => {
      const step = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, -STEP], ArrowDown: [0, STEP] }[
        event.key
      ];
      if (!step || (step[0] !== 0 && !movesX) || (step[1] !== 0 && !movesY)) return;
      set({ x: share.x + step[0], y: share.y + step[1] });
      event.preventDefault();
      event.stopPropagation();
    };
    const style = {
      ...(movesX ? { left: `${100 * share.x}%` } : {}),
      ...(movesY ? { top: `${100 * share.y}%` } : {}),
    };
    const part = Math.round(100 * (moves === 'y' ? share.y : share.x));
    return (
      // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions -- a separator with a value is a control
      <div
        className="pane-edge"
        data-moves={moves}
        style={style}
        role="separator"
        // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a separator with a value is a control
        tabIndex={0}
        aria-label={label}
        aria-orientation={moves === 'y' ? 'horizontal' : 'vertical'}
        aria-valuenow={part}
        aria-valuemin={100 * LEAST_SHARE}
        aria-valuemax={100 * (1 - LEAST_SHARE)}
        onPointerDown={(event) => event.button === 0 && event.currentTarget.setPointerCapture(event.pointerId)}
        onPointerMove={drag}
        onDoubleClick={() => set({ x: movesX ? 0.5 : share.x, y: movesY ? 0.5 : share.y })}
        onKeyDown={keyDown}
      />
    );
  };
  return (
    <>
      {edge('x', t('Edge between the views at the left and at the right'))}
      {edge('y', t('Edge between the views above and below'))}
      {edge('both', t('Corner between the four views'))}
    </>
  );
}
