/**
 * Draws a drape with dummy, floor and light into a target with depth, and copies it to the stage's
 * canvas.
 */
import {
  AlwaysDepth,
  BufferAttribute,
  BufferGeometry,
  Color,
  DepthTexture,
  DoubleSide,
  LinearFilter,
  LinearSRGBColorSpace,
  Matrix4,
  Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  PerspectiveCamera,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  WebGLRenderTarget,
  type Texture,
  type WebGLRenderer,
} from 'three';

import type {Raster} from '../stage.js';
import {eyeOf, fieldOfView, type Orbit} from './camera.js';
import {footRadius, type Solid} from './dummy.js';
import {coarser, finest, type Fineness} from './fineness.js';
import {fabricLooks, weaves, type FabricLook} from './fabric-look.js';
import * as shaders from './shaders.js';
import type {Box3} from './space.js';

/** Side of the key light's shadow map. [px] */
const shadowSide = 1024;
/** Direction from the target to the key light, relative to the camera: from above and the left. */
const keyWay = new Vector3(-0.5, 0.72, 0.62).normalize();
/** Unprinted fabric, as on the flat pattern. */
const bareFabric = [0.925, 0.91, 0.87] as const;
/** Greatest radius of the soft shadow; arms held aside are far above the floor. [cm] */
const widestShadow = 34;
/** Matches no piece. */
const noPiece = -1;

/** A vertical part of the picture between two shares of its width, from the left. */
interface Part {
  readonly from: number;
  readonly to: number;
  /** Uses the print coordinates as drafted. */
  readonly isDrafted: boolean;
}

interface Targets {
  readonly picture: WebGLRenderTarget;
  /** Target for moving garments, without multisampling. */
  readonly moving: WebGLRenderTarget;
  readonly shadows: WebGLRenderTarget;
}

/**
 * Shared by all views of a renderer, since they are drawn one after the other; the targets grow
 * with the largest.
 */
const known = new WeakMap<WebGLRenderer, Targets>();

function targetsOf(renderer: WebGLRenderer): Targets {
  let targets = known.get(renderer);
  if (!targets) {
    const filters = {minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false};
    targets = {
      picture: new WebGLRenderTarget(1, 1, {...filters, samples: finest.samples}),
      moving: new WebGLRenderTarget(1, 1, {...filters, magFilter: LinearFilter}),
      shadows: new WebGLRenderTarget(shadowSide, shadowSide, {
        ...filters,
        depthTexture: new DepthTexture(shadowSide, shadowSide),
      }),
    };
    known.set(renderer, targets);
  }
  return targets;
}

const shader = (
  {vertex, fragment}: {readonly vertex: string; readonly fragment: string},
  uniforms: ShaderMaterial['uniforms'] = {},
): ShaderMaterial => new ShaderMaterial({vertexShader: vertex, fragmentShader: fragment, uniforms});

const uniformsOf = (look: FabricLook) => ({
  weave: {value: weaves[look.weave] as number},
  pitch: {value: look.pitch},
  relief: {value: look.relief},
  sheen: {value: look.sheen},
  opacity: {value: look.opacity},
  thickness: {value: look.hem},
  stitch: {value: look.stitch},
});
type Uniforms = ReturnType<typeof uniformsOf>;

const rgb = ([r, g, b]: readonly [number, number, number]): Color =>
  new Color().setRGB(r, g, b, LinearSRGBColorSpace);

export class Studio {
  readonly #light = {
    key: {value: new Vector3()},
    shadowMatrix: {value: new Matrix4()},
    shadows: {value: null as Texture | null},
  };
  readonly #print = {
    tile: {value: null as Texture | null},
    bare: {value: rgb(bareFabric)},
    accent: {value: new Color()},
    chosen: {value: noPiece},
    pointed: {value: noPiece},
    isDrafted: {value: false},
  };
  readonly #look = uniformsOf(fabricLooks.poplin);
  readonly #clothMaterial = shader(shaders.cloth, {
    ...this.#light,
    ...this.#print,
    ...this.#look,
  });
  readonly #dummyMaterial = shader(shaders.dummy, this.#light);
  readonly #depthMaterial = shader(shaders.depth);
  /** Keeps what is behind the front of sheer fabric out of the picture, but for the form. */
  readonly #frontMaterial = shader(shaders.depth);
  readonly #floorMaterial = shader(shaders.floor, {
    soft: {value: new Vector2(1, 1)},
    foot: {value: footRadius},
    middle: {value: 0},
    strength: {value: 1},
  });
  readonly #copyMaterial = shader(shaders.copy, {
    picture: {value: null as Texture | null},
    part: {value: new Vector2(1, 1)},
  });
  readonly ribbonMaterial = shader(shaders.ribbon, {perPixel: {value: 0}});
  readonly #cloth = this.#mesh(this.#clothMaterial);
  readonly #hems = this.#mesh(this.#clothMaterial);
  readonly #front = this.#mesh(this.#frontMaterial);
  readonly #body = this.#mesh(this.#dummyMaterial);
  readonly #stand = this.#mesh(this.#dummyMaterial);
  readonly #floor = this.#mesh(this.#floorMaterial, ['position']);
  /** The fabric only: the form is inside of it. */
  readonly #shade = this.#mesh(this.#depthMaterial);
  readonly #copy = this.#mesh(this.#copyMaterial, ['position']);
  readonly #scene = new Scene();
  readonly #shadowScene = new Scene();
  readonly #copyScene = new Scene();
  readonly #camera = new PerspectiveCamera((fieldOfView * 180) / Math.PI);
  readonly #keyCamera = new OrthographicCamera();

  constructor() {
    this.#clothMaterial.side = DoubleSide;
    this.#depthMaterial.side = DoubleSide;
    Object.assign(this.#frontMaterial, {
      ...{side: DoubleSide, colorWrite: false},
      ...{polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1},
    });
    this.#front.visible = false;
    this.#front.renderOrder = 1; // after the form, which shows through
    this.ribbonMaterial.side = DoubleSide;
    Object.assign(this.#floorMaterial, {transparent: true, depthWrite: false, side: DoubleSide});
    Object.assign(this.#copyMaterial, {
      ...{blending: NoBlending, depthTest: false, depthWrite: false, depthFunc: AlwaysDepth},
    });
    this.#scene.add(this.#floor, this.#front, this.#cloth, this.#hems, this.#body, this.#stand);
    this.#floor.renderOrder = -1;
    this.#shadowScene.add(this.#shade);
    this.#copy.geometry.setAttribute(
      'position',
      new BufferAttribute(Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0), 3),
    );
    this.#copyScene.add(this.#copy);
  }

  /** Compiles the shaders before the first drawing, since this takes longer than a frame. */
  prepare(renderer: WebGLRenderer): void {
    const before = renderer.getRenderTarget();
    const {picture, shadows} = targetsOf(renderer);
    for (const [target, scene, camera] of [
      [shadows, this.#shadowScene, this.#keyCamera],
      [picture, this.#scene, this.#camera],
      [before, this.#copyScene, this.#keyCamera],
    ] as const) {
      renderer.setRenderTarget(target);
      renderer.compile(scene, camera);
    }
    // each query has its own task, since it waits for the graphics card
    for (const program of renderer.info.programs ?? [])
      setTimeout(() => {
        if (program.usedTimes > 0) program.getUniforms();
      });
  }

  get scene(): Scene {
    return this.#scene;
  }

  set tile(tile: Texture) {
    this.#print.tile.value = tile;
  }

  /** @param accent tint of marked pieces, sRGB from 0 to 255 */
  mark(chosen = noPiece, pointed = noPiece, accent: readonly [number, number, number]): void {
    this.#print.chosen.value = chosen;
    this.#print.pointed.value = pointed;
    const [r, g, b] = accent;
    this.#print.accent.value = rgb([r / 255, g / 255, b / 255]);
  }

  set look(look: FabricLook) {
    for (const [name, {value}] of Object.entries(uniformsOf(look)))
      this.#look[name as keyof Uniforms].value = value;
    const isSheer = look.opacity < 1;
    this.#clothMaterial.transparent = isSheer;
    this.#front.visible = isSheer;
  }

  /** Sets the geometries of the fabric and of the thickness along its edges. */
  setCloth(geometry: BufferGeometry, hems: BufferGeometry): void {
    replace(this.#cloth, geometry);
    replace(this.#hems, hems);
    for (const other of [this.#shade, this.#front]) other.geometry = geometry;
  }

  setDummy(body: Solid, stand: Solid): void {
    replace(this.#body, solidGeometry(body));
    replace(this.#stand, solidGeometry(stand));
  }

  /** Sets whether the dummy and its floor are visible. */
  set hasDummy(isShown: boolean) {
    for (const mesh of [this.#body, this.#stand, this.#floor]) mesh.visible = isShown;
  }

  /** @param box of everything above the floor [cm] @param strength of the shadow */
  setFloor(height: number, middle: number, {low, high}: Box3, strength: number): void {
    const soft = [1, 1].map((_, k) => {
      const axis = 2 * k;
      const reach = Math.max(Math.abs(low[axis] ?? 0), Math.abs(high[axis] ?? 0));
      return 8 + Math.min(widestShadow, reach);
    });
    const side = 3 * Math.max(...soft);
    const corners = [-1, -1, 1, -1, -1, 1, 1, 1];
    const positions = new Float32Array(12);
    for (let k = 0; k < 4; k++) {
      const [x = 0, z = 0] = corners.slice(2 * k, 2 * k + 2);
      positions.set([side * x, height, middle + side * z], 3 * k);
    }
    const {geometry, material} = this.#floor;
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const {uniforms} = material;
    (uniforms.soft?.value as Vector2).set(soft[0] ?? 1, soft[1] ?? 1);
    if (uniforms.middle) uniforms.middle.value = middle;
    if (uniforms.strength) uniforms.strength.value = strength;
  }

  /**
   * Draws into the lower left corner of the current render target.
   * @param whole size of that corner
   * @param box of the whole scene [cm]
   * @param begin called before each part
   */
  draw(
    renderer: WebGLRenderer,
    whole: Raster,
    fineness: Fineness,
    orbit: Orbit,
    box: Box3,
    parts: readonly Part[],
    begin: (part: Part) => void,
  ): void {
    const before = renderer.getRenderTarget();
    const {shadows, ...targets} = targetsOf(renderer);
    const picture = fineness.samples > 0 ? targets.picture : targets.moving;
    const raster = coarser(whole, fineness);
    this.#aim(orbit, box, raster);
    this.#light.shadows.value = shadows.depthTexture;
    renderer.setRenderTarget(shadows);
    renderer.clear();
    renderer.render(this.#shadowScene, this.#keyCamera);
    const {width, height} = raster;
    if (picture.width < width || picture.height < height)
      picture.setSize(Math.max(width, picture.width), Math.max(height, picture.height));
    picture.viewport.set(0, 0, width, height);
    picture.scissorTest = true;
    for (const part of parts) {
      begin(part);
      this.#print.isDrafted.value = part.isDrafted;
      const [left, right] = [Math.round(part.from * width), Math.round(part.to * width)];
      picture.scissor.set(left, 0, right - left, height);
      renderer.setRenderTarget(picture);
      renderer.clear();
      renderer.render(this.#scene, this.#camera);
    }
    renderer.setRenderTarget(before);
    const {uniforms} = this.#copyMaterial;
    if (uniforms.picture) uniforms.picture.value = picture.texture;
    (uniforms.part?.value as Vector2).set(width / picture.width, height / picture.height);
    renderer.render(this.#copyScene, this.#keyCamera);
  }

  dispose(): void {
    const meshes = [this.#cloth, this.#hems, this.#body, this.#stand, this.#floor, this.#copy];
    for (const {geometry, material} of meshes) {
      geometry.dispose();
      material.dispose();
    }
    this.#depthMaterial.dispose();
    this.#frontMaterial.dispose();
    this.ribbonMaterial.dispose();
  }

  /** @param names attributes that select the shader variant */
  #mesh(
    material: ShaderMaterial,
    names: readonly string[] = ['position', 'normal'],
  ): Mesh<BufferGeometry, ShaderMaterial> {
    const geometry = new BufferGeometry();
    for (const name of names)
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(), 3));
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
  }

  #aim(orbit: Orbit, {low, high}: Box3, {width, height, ratio}: Raster): void {
    const camera = this.#camera;
    camera.aspect = width / height;
    camera.near = Math.max(2, orbit.distance - 250);
    camera.far = orbit.distance + 400;
    camera.position.set(...eyeOf(orbit));
    camera.up.set(0, 1, 0);
    camera.lookAt(...orbit.target);
    camera.updateProjectionMatrix();
    const {perPixel} = this.ribbonMaterial.uniforms;
    if (perPixel) perPixel.value = (2 * Math.tan(fieldOfView / 2) * ratio) / height;
    const key = this.#light.key.value.copy(keyWay).applyAxisAngle(camera.up, orbit.azimuth);
    const middle = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    const radius = new Vector3(...high).sub(middle).length();
    const light = this.#keyCamera;
    light.left = light.bottom = -radius;
    light.right = light.top = radius;
    light.near = 0;
    light.far = 2 * radius;
    light.position.copy(middle).addScaledVector(key, radius);
    light.lookAt(middle);
    light.updateProjectionMatrix();
    light.updateMatrixWorld();
    const halves = new Matrix4().set(
      ...([0.5, 0, 0, 0.5, 0, 0.5, 0, 0.5] as const),
      ...([0, 0, 0.5, 0.5, 0, 0, 0, 1] as const),
    );
    this.#light.shadowMatrix.value
      .copy(halves)
      .multiply(light.projectionMatrix)
      .multiply(light.matrixWorldInverse);
  }
}

/** Returns a solid as three.js draws it. */
export function solidGeometry({positions, normals, colours, triangles}: Solid): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const [name, array] of [
    ['position', positions],
    ['normal', normals],
    ['colour', colours],
  ] as const)
    geometry.setAttribute(name, new BufferAttribute(array, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return geometry;
}

function replace(mesh: Mesh, geometry: BufferGeometry): void {
  mesh.geometry.dispose();
  mesh.geometry = geometry;
}
