import { t } from '@farol/editing';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useEffect, useRef, useState } from 'react';
import type { Material } from 'three';
import { useEditor, useSignal } from './EditorContext';

/** Side of the canvas (CSS pixels). */
const SIZE = 112;

/** Rotation per press of an arrow key (rad). */
const KEY_TURN = Math.PI / 12;

const turns: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-KEY_TURN, 0],
  ArrowRight: [KEY_TURN, 0],
  ArrowUp: [0, -KEY_TURN],
  ArrowDown: [0, KEY_TURN],
};

interface TurningBallProps {
  /** Material shown on the ball; null for none. */
  materialOf(): Material | null;
  /** Changes each time the material may look different. */
  readonly revision: number;
  readonly label: string;
}

/** Preview sphere of a material, updated when the material changes, and rotated by dragging or arrow keys. */
export function TurningBall({ materialOf, revision, label }: TurningBallProps): ReactNode {
  const editor = useEditor();
  const { viewport, document } = editor;
  const assets = useSignal(document.assetsChanged);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [turn, setTurn] = useState<readonly [number, number]>([0, 0]);
  const material = useRef(materialOf);
  useEffect(() => {
    material.current = materialOf;
  });
  useEffect(() => {
    // the sphere is drawn once per frame for all changes, including the end of a drag
    const frame = requestAnimationFrame(() => {
      const drawn = material.current();
      const place = canvas.current;
      if (drawn && place) editor.attempt(() => viewport.drawMaterial(drawn, place, turn));
    });
    return () => cancelAnimationFrame(frame);
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- each means that the material may look different
  }, [editor, viewport, revision, assets, turn]);

  const turnBy = (right: number, up: number): void =>
    setTurn((before) => [before[0] + right, Math.min(Math.PI / 2, Math.max(-Math.PI / 2, before[1] + up))]);
  const drag = (event: PointerEvent): void => {
    if (event.buttons & 1) turnBy((event.movementX / SIZE) * 3, (event.movementY / SIZE) * 3);
  };
  const press = (event: KeyboardEvent): void => {
    const by = turns[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    turnBy(...by);
  };
  return (
    <div className="material-preview">
      <canvas
        ref={canvas}
        width={SIZE * 2}
        height={SIZE * 2}
        role="img"
        tabIndex={0}
        aria-label={label}
        title={t('Drag to turn it')}
        onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
        onPointerMove={drag}
        onDoubleClick={() => setTurn([0, 0])}
        onKeyDown={press}
      />
    </div>
  );
}
