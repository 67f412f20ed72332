import { t } from '@farol/editing';
import type { Model } from '@farol/engine';
import type { ReactNode } from 'react';
import type { Object3D } from 'three';
import { Icon } from '../../ui/Icon';
import { Section } from '../inspector/Section';
import type { IconName } from '../../style/iconPaths';

/** Objects of a model that are listed. */
const MOST = 200;

function iconOf(object: Object3D): IconName {
  if ('isMesh' in object) return 'mesh';
  if ('isLight' in object) return 'point';
  return 'isCamera' in object ? 'camera' : 'object';
}

interface Line {
  readonly object: Object3D;
  readonly depth: number;
}

function linesOf(model: Model): { lines: Line[]; left: number } {
  const lines: Line[] = [];
  let count = 0;
  const visit = (object: Object3D, depth: number): void => {
    if (++count <= MOST) lines.push({ object, depth });
    for (const child of object.children) visit(child, depth + 1);
  };
  for (const child of model.scene.children) visit(child, 0);
  return { lines, left: Math.max(0, count - MOST) };
}

/** What is inside a model: its tree, to be looked at, and its clips. */
export function ModelInside({ model }: { model: Model }): ReactNode {
  const { lines, left } = linesOf(model);
  return (
    <>
      <Section
        id="Model inside"
        title={t('Inside')}
        help={t('The objects of the model. Unpack it to edit them.')}
        icon="tree"
      >
        <ul className="model-inside">
          {lines.map(({ object, depth }) => (
            <li key={object.uuid} style={{ paddingInlineStart: depth * 12 }}>
              <Icon name={iconOf(object)} size={12} />
              <span>{object.name || object.type}</span>
            </li>
          ))}
        </ul>
        {left > 0 && <p className="asset-note">{t('And {count} more.', { count: left })}</p>}
      </Section>
      {model.animations.length > 0 && (
        <Section id="Model clips" title={t('Clips')} help={t('The animations of the model.')} icon="play">
          <ul className="model-inside">
            {model.animations.map(({ name, duration, uuid }) => (
              <li key={uuid}>
                <span>{name}</span>
                <span className="used-field">{`${duration.toFixed(2)} s`}</span>
              </li>
            ))}
          </ul>
        </Section>
      )}
    </>
  );
}
