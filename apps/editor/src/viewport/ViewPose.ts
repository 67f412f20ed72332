/** Pose and lens of the editor's camera. */
export interface ViewPose {
  /** World position of the eye (m). */
  readonly position: readonly [number, number, number];
  /** Orbit target (m, world), never equal to `position`. Its distance determines the size of an orthographic view. */
  readonly target: readonly [number, number, number];
  /** Vertical field of view for a wide aspect ratio (rad); narrow viewports show more vertically. */
  readonly fov: number;
  readonly orthographic: boolean;
}
