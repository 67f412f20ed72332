import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { useIsFiltering } from '../../ui/FieldFilter';
import { Icon } from '../../ui/Icon';
import { usePreferences } from '../../ui/usePreferences';

interface FieldGroupProps {
  /** Under this name it is remembered whether the group is folded. */
  readonly id: string;
  readonly title: string;
  readonly children: ReactNode;
}

/** Fields of a section that belong together; they fold, and stay so. */
export function FieldGroup({ id, title, children }: FieldGroupProps): ReactNode {
  const { preferences } = useEditor();
  const isFiltering = useIsFiltering();
  const isFolded = usePreferences(({ folded }) => folded[id] ?? false) && !isFiltering;
  const fold = (): void => {
    preferences.setState((before) => ({ folded: { ...before.folded, [id]: !isFolded } }));
  };
  return (
    <div className="field-group" role="group" aria-label={t(title)}>
      <button type="button" className="field-group-title" aria-expanded={!isFolded} onClick={fold}>
        <span className="fold" data-open={!isFolded}>
          <Icon name="chevron" size={9} />
        </span>
        {t(title)}
      </button>
      {!isFolded && children}
    </div>
  );
}
