import { t, tCount } from '@farol/editing';
import type { Model } from '@farol/engine';
import { type ReactNode, useMemo } from 'react';
import type { Object3D } from 'three';
import { Icon } from '../../ui/Icon';
import type { IconName } from '../../style/iconPaths';
import './material.css';

/** Maximum number of a model's objects that are listed. */
const MOST = 200;

/** Number of levels of the model's tree that are unfolded at first. */
const OPEN_LEVELS = 2;

function iconOf(object: Object3D): IconName {
  if ('isMesh' in object) return 'mesh';
  if ('isLight' in object) return 'point';
  if ('isBone' in object) return 'joint';
  return 'isCamera' in object ? 'camera' : 'object';
}

/** Features of an object that are lost when its model is unpacked, such as a skeleton; '' for none. */
function keptWhole(object: Object3D): string {
  if ('isSkinnedMesh' in object) return t('with a skeleton');
  if ('isInstancedMesh' in object) return t('with instances');
  const morphs = (object as { morphTargetInfluences?: readonly number[] }).morphTargetInfluences?.length ?? 0;
  return morphs === 0 ? '' : tCount(morphs, 'with {count} morph target', 'with {count} morph targets');
}

const countOf = (root: Object3D): number => root.children.reduce((sum, child) => sum + 1 + countOf(child), 0);

/** The objects of a model as a foldable tree, read-only. */
export function ModelTree({ model }: { model: Model }): ReactNode {
  const tree = useMemo(() => {
    let remaining = MOST;
    const listOf = (objects: readonly Object3D[], depth: number): ReactNode => {
      const lines: ReactNode[] = [];
      for (const object of objects) {
        if (remaining-- <= 0) break;
        const line = (
          <span className="model-node">
            <Icon name={iconOf(object)} size={12} />
            <span>{object.name || object.type}</span>
            <span className="used-field">{keptWhole(object)}</span>
          </span>
        );
        lines.push(
          <li key={object.uuid}>
            {object.children.length === 0 ? (
              line
            ) : (
              <details open={depth < OPEN_LEVELS}>
                <summary>{line}</summary>
                {listOf(object.children, depth + 1)}
              </details>
            )}
          </li>,
        );
      }
      return <ul>{lines}</ul>;
    };
    return listOf(model.scene.children, 0);
  }, [model]);
  const beyond = countOf(model.scene) - MOST;
  return (
    <div className="model-tree">
      {tree}
      {beyond > 0 && <p className="asset-note">{t('And {count} more.', { count: beyond })}</p>}
    </div>
  );
}
