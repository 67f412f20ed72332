import { t } from '@farol/editing';
import type { Model } from '@farol/engine';
import type { ReactNode } from 'react';
import { Section } from '../inspector/Section';
import { ModelTree } from './ModelTree';

/** Contents of a model: its tree of objects, and its clips. */
export function ModelInside({ model }: { model: Model }): ReactNode {
  return (
    <>
      <Section
        id="Model inside"
        title={t('Inside')}
        help={t('The objects of the model. Unpack it to edit them.')}
        icon="tree"
      >
        <ModelTree model={model} />
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
