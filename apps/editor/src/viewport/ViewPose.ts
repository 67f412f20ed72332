/** From where the editor looks at a scene. */
export interface ViewPose {
  /** Of the eye, in the world (m). */
  readonly position: readonly [number, number, number];
  /** What is orbited, in the world (m); not at the eye. Its distance tells the size of a picture without perspective. */
  readonly target: readonly [number, number, number];
  /** Vertical, of a wide picture (rad). */
  readonly fov: number;
  /** Whether it is without perspective. */
  readonly orthographic: boolean;
}
