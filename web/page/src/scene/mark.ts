import { SHAPES } from "./draw-list";

/** One mark around a pixel: the same shapes in the scene, the plots and the key. */
export function paintMark(
  context: CanvasRenderingContext2D,
  { x, y }: { x: number; y: number },
  radius: number,
  shape: number,
  color: string,
): void {
  context.fillStyle = color;
  context.strokeStyle = color;
  context.lineWidth = Math.max(1.5, radius * 0.4);
  context.setLineDash([]);
  context.beginPath();
  if (shape === SHAPES.disc || shape === SHAPES.ring) context.arc(x, y, radius, 0, 2 * Math.PI);
  for (const [dx, dy] of outline(shape)) context.lineTo(x + dx * radius, y + dy * radius);
  if (shape === SHAPES.cross) {
    context.moveTo(x - 0.8 * radius, y - 0.8 * radius);
    context.lineTo(x + 0.8 * radius, y + 0.8 * radius);
    context.moveTo(x - 0.8 * radius, y + 0.8 * radius);
    context.lineTo(x + 0.8 * radius, y - 0.8 * radius);
  }
  if (shape === SHAPES.cross || shape === SHAPES.ring) context.stroke();
  else context.fill();
}

/** Corners in units of the radius; none for round marks and the cross. */
export function outline(shape: number): readonly (readonly [number, number])[] {
  if (shape === SHAPES.square)
    return [
      [-0.8, -0.8],
      [0.8, -0.8],
      [0.8, 0.8],
      [-0.8, 0.8],
    ];
  if (shape === SHAPES.triangle)
    return [
      [0, -1],
      [0.95, 0.75],
      [-0.95, 0.75],
    ];
  if (shape === SHAPES.diamond)
    return [
      [0, -1.1],
      [1.1, 0],
      [0, 1.1],
      [-1.1, 0],
    ];
  return [];
}
