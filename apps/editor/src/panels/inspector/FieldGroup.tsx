import { t } from '@farol/editing';
import { type ReactNode, useState } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { useIsFiltering } from '../../ui/FieldFilter';
import { Icon } from '../../ui/Icon';
import { usePreferences } from '../../ui/usePreferences';

interface FieldGroupProps {
  /** Key under which the folded state is stored. */
  readonly id: string;
  readonly title: string;
  /** Whether the group is folded by default; called once, so that edits never fold it. */
  readonly isFoldedAtFirst: () => boolean;
  readonly children: ReactNode;
}

/** A foldable group of fields in a section; its state is remembered. */
export function FieldGroup({ id, title, isFoldedAtFirst, children }: FieldGroupProps): ReactNode {
  const { preferences } = useEditor();
  const isFiltering = useIsFiltering();
  const [first] = useState(isFoldedAtFirst);
  const isFolded = usePreferences(({ folded }) => folded[id] ?? first) && !isFiltering;
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
