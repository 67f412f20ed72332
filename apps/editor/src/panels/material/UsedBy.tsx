import { t, tCount } from '@farol/editing';
import { type ReactNode, useMemo } from 'react';
import { Section } from '../inspector/Section';
import { usagesOf } from '../../model/assetUsages';
import { instancesOf } from '../../model/prefabEdits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';

/** Maximum number of places listed; the others are counted. */
const MOST = 50;

/** Places that use an asset; clicking one selects its object. */
export function UsedBy({ name }: { name: string }): ReactNode {
  const { document, commands } = useEditor();
  useSignal(commands.changed);
  // the list is updated after commands only, not after each preview of a drag
  const step = commands.last;
  const { scene } = document;
  const usages = useMemo(() => {
    const instances = scene.prefabs.get(name) ? instancesOf(scene, name) : [];
    if (instances.length > 0) return instances.map(({ id, name: place }) => ({ place, field: '', object: id }));
    return usagesOf(scene, name);
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- the step changes whenever the scene does
  }, [scene, name, step]);
  const objects = [...new Set(usages.flatMap(({ object }) => object ?? []))];
  return (
    <Section id="Used by" title={t('Used by')} help={t('Objects and assets that use this asset.')} icon="tree">
      {usages.length === 0 && <p className="asset-note">{t('Nothing in the scene uses it.')}</p>}
      {objects.length > 0 && (
        <Button
          label={tCount(objects.length, 'Select {count} object', 'Select {count} objects')}
          onClick={() => document.selection.set(objects)}
        />
      )}
      <ul className="used-by">
        {usages.slice(0, MOST).map(({ place, field, object }, i) => (
          <li key={i}>
            {object === undefined ? (
              <span>{place}</span>
            ) : (
              <button type="button" className="link" onClick={() => document.selection.set([object])}>
                {place}
              </button>
            )}
            <span className="used-field">{field}</span>
          </li>
        ))}
      </ul>
      {usages.length > MOST && <p className="asset-note">{t('And {count} more.', { count: usages.length - MOST })}</p>}
    </Section>
  );
}
