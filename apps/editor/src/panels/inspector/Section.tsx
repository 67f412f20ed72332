import type { ReactNode } from 'react';
import { Icon } from '../../ui/Icon';
import type { IconName } from '../../style/iconPaths';
import { SectionTitle, useIsFiltering } from '../../ui/FieldFilter';
import { useEditor } from '../../ui/EditorContext';
import { usePreferences } from '../../ui/usePreferences';

interface SectionProps {
  /** Key under which the folded state is stored. */
  readonly id: string;
  readonly title: string;
  readonly help: string;
  readonly icon: IconName;
  readonly isFoldedAtFirst?: boolean;
  /** Controls at the right of the title. */
  readonly controls?: ReactNode;
  readonly children: ReactNode;
}

/** Whether a part is folded, which is remembered, and a function that folds or unfolds it. */
export function useFold(id: string, isFoldedAtFirst: boolean): [isFolded: boolean, fold: () => void] {
  const { preferences } = useEditor();
  const isFiltering = useIsFiltering();
  const isFolded = usePreferences(({ folded }) => folded[id] ?? isFoldedAtFirst) && !isFiltering;
  return [isFolded, () => preferences.setState(({ folded }) => ({ folded: { ...folded, [id]: !isFolded } }))];
}

export function Section(props: SectionProps): ReactNode {
  const { id, title, help, icon, isFoldedAtFirst = false, controls, children } = props;
  const [isFolded, fold] = useFold(id, isFoldedAtFirst);
  return (
    <section className="section" aria-label={title}>
      <header className="section-header">
        <h3>
          <button type="button" className="section-title" aria-expanded={!isFolded} title={help} onClick={fold}>
            <span className="fold" data-open={!isFolded}>
              <Icon name="chevron" size={10} />
            </span>
            <Icon name={icon} size={14} />
            {title}
          </button>
        </h3>
        {controls}
      </header>
      {!isFolded && (
        <SectionTitle value={title}>
          <div className="section-body">{children}</div>
        </SectionTitle>
      )}
    </section>
  );
}
