import { t } from '@farol/editing';
import { labelOf } from '../../api/Action';
import { type ReactNode, useEffect, useRef, useSyncExternalStore } from 'react';
import { Matrix4 } from 'three';
import { lookFrom, sideName, sides, toggleOrthographic } from '../../actions/viewpoint';
import { useEditor } from '../../ui/EditorContext';
import { keyText } from '../../ui/keyText';
import { useKeyBindings } from '../../ui/useKeyBindings';

const matrix = new Matrix4();

/** CSS rotation of each face of the cube, from facing the viewer. */
const turns = {
  right: 'rotateY(90deg)',
  left: 'rotateY(-90deg)',
  top: 'rotateX(90deg)',
  bottom: 'rotateX(-90deg)',
  front: '',
  back: 'rotateY(180deg)',
};

/** Cube that rotates with the view; clicking a face looks from that side. Rotates without rendering React. */
export function ViewCube(): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  const cube = useRef<HTMLDivElement>(null);
  useEffect(() => {
    let lastTransform = '';
    const follow = (): void => {
      // CSS matrix of the view's rotation; y points down in CSS
      const e = matrix.extractRotation(viewport.camera.matrixWorldInverse).elements;
      const n = (value: number): string => value.toFixed(3);
      const transform = `matrix3d(${n(e[0])},${n(-e[1])},${n(e[2])},0,${n(-e[4])},${n(e[5])},${n(-e[6])},0,${n(e[8])},${n(-e[9])},${n(e[10])},0,0,0,0,1)`;
      if (transform === lastTransform || !cube.current) return;
      lastTransform = transform;
      cube.current.style.transform = transform;
    };
    follow();
    return viewport.drawn.subscribe(follow);
  }, [viewport]);
  return (
    <div className="view-cube-row">
      <div className="view-cube" role="group" aria-label={t('View cube')}>
        <div ref={cube} className="view-cube-body">
          {sides.map(([side], i) => (
            <button
              key={side}
              type="button"
              className={`view-cube-face ${side}`}
              style={{ transform: `${turns[side]} translateZ(24px)` }}
              aria-label={labelOf(lookFrom[i], editor)}
              title={labelOf(lookFrom[i], editor)}
              onClick={() => editor.attempt(() => lookFrom[i].run(editor))}
            >
              {sideName(side)}
            </button>
          ))}
        </div>
      </div>
      <ProjectionButton />
    </div>
  );
}

/** Button that shows and toggles the projection. */
function ProjectionButton(): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  const isFlat = useSyncExternalStore(viewport.drawn.subscribe, () => viewport.editorCamera.orthographic);
  const label = isFlat ? t('Orthographic') : t('Perspective');
  const key = useKeyBindings().keysOf(toggleOrthographic).at(0);
  return (
    <button
      type="button"
      className="button small projection"
      title={key ? `${label} (${keyText(key)})` : label}
      onClick={() => editor.attempt(() => toggleOrthographic.run(editor))}
    >
      {label}
    </button>
  );
}
