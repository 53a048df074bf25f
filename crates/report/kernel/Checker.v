(* The checker: integers alone. A triple is a closed half-plane x*theta1 + y*theta2 + w >= 0, a point (x/w, y/w), or with
   w = 0 a direction. *)
From Coq Require Import ZArith QArith List.
From Boundfit Require Import Reader.
Import ListNotations.
Local Open Scope Z_scope.

Record triple := T { tx : Z; ty : Z; tw : Z }.
Definition dot (h g : triple) := tx h * tx g + ty h * ty g + tw h * tw g.
Definition turn (a b : triple) := tx a * ty b - ty a * tx b.
Definition cross (a b : triple) :=
  T (ty a * tw b - tw a * ty b) (tw a * tx b - tx a * tw b) (tx a * ty b - ty a * tx b).
Definition det (a b c : triple) := dot (cross a b) c.
Definition infinity := T 0 0 1.
Definition is_same (a b : triple) := (tx a =? tx b) && (ty a =? ty b) && (tw a =? tw b).

(* low <= first*theta1 + second*theta2 <= high, as far as there are bounds. *)
Record form := Form { first : Q; second : Q; low : option Q; high : option Q }.

(* a*theta1 + b*theta2 + c = v. *)
Definition level (a b c v : Q) : form := Form a b (Some (v - c)%Q) (Some (v - c)%Q).

(* A condition as a row of text: its first and second coefficient, and its bounds. *)
Definition form_of (r : row) : form := Form (number 0 r) (number 1 r) (entry 2 r) (entry 3 r).

(* The number of a half-plane in text. *)
Definition number_of (r : row) : Z := Qnum (number 0 r).

Definition upper (u v b : Q) : triple :=
  let '(un # ud, vn # vd, bn # bd)%Q := (u, v, b) in
  if (ud =? bd)%positive then T (- (un * Zpos vd)) (- (vn * Zpos ud)) (bn * Zpos vd)
  else T (- (un * (Zpos vd * Zpos bd))) (- (vn * (Zpos ud * Zpos bd))) (bn * (Zpos ud * Zpos vd)).
Definition opposite (h : triple) := T (- tx h) (- ty h) (- tw h).
Definition halves (c : form) : list triple :=
  match low c with Some b => [opposite (upper (first c) (second c) b)] | None => [] end ++
  match high c with Some b => [upper (first c) (second c) b] | None => [] end.

Definition sum (a b : Q) : Q :=
  let '(an # ad, bn # bd)%Q := (a, b) in
  if (ad =? bd)%positive then (an + bn # ad)%Q else (an * Zpos bd + bn * Zpos ad # ad * bd)%Q.
Definition around (u v y e : Q) : form := Form u v (Some (sum y (- e)%Q)) (Some (sum y e)).

Definition vertex (v : Q * Q) : triple :=
  let '(xn # xd, yn # yd)%Q := v in
  if (xd =? yd)%positive then T xn yn (Zpos xd) else T (xn * Zpos yd) (yn * Zpos xd) (Zpos xd * Zpos yd).
Definition ray (v : Q * Q) : triple :=
  let '(xn # xd, yn # yd)%Q := v in T (xn * Zpos yd) (yn * Zpos xd) 0.

(* Half-planes by their numbers, from 1; 0 is the line at infinity. *)
Inductive tree := Leaf | Node (l : tree) (v : option triple) (r : tree).
Fixpoint put (i : positive) (h : triple) (t : tree) : tree :=
  let '(l, v, r) := match t with Leaf => (Leaf, None, Leaf) | Node l v r => (l, v, r) end in
  match i with xH => Node l (Some h) r | xO i => Node (put i h l) v r | xI i => Node l v (put i h r) end.
Fixpoint get (i : positive) (t : tree) : option triple :=
  match t, i with
  | Leaf, _ => None
  | Node _ v _, xH => v
  | Node l _ _, xO i => get i l
  | Node _ _ r, xI i => get i r
  end.
Fixpoint table (l : list triple) (i : positive) (t : tree) : tree :=
  match l with [] => t | h :: l => table l (Pos.succ i) (put i h t) end.
Definition side (t : tree) (i : Z) : triple :=
  match i with Zpos i => match get i t with Some h => h | None => infinity end | _ => infinity end.

(* A half-plane that holds at the vertex v of two sides, and whose normal lies between theirs, holds where the sides do. *)
Definition turns (a b : triple) : comparison :=
  if ty a =? ty b then match ty a with Z0 => Eq | Zpos _ => tx a ?= tx b | Zneg _ => tx b ?= tx a end
  else tx a * ty b ?= ty a * tx b.
Definition not_right (a b : triple) := match turns a b with Lt => false | _ => true end.
Record corner := Corner { before : triple; at_ : triple; after : triple }.
Definition is_corner (c : corner) :=
  (0 <? tw (at_ c)) && (0 <? turn (before c) (after c)) && (dot (before c) (at_ c) =? 0) && (dot (after c) (at_ c) =? 0).
Definition enclosed (c : corner) (h : triple) :=
  not_right (before c) h && not_right h (after c) && (0 <=? dot h (at_ c)).

(* Corners by angle. Which one is found is not trusted. *)
Inductive order := Tip | Fork (l : order) (c : corner) (is_late : bool) (r : order).
Definition is_late (base h : triple) : bool :=
  match turns base h with Gt => false | Lt => true | Eq => tx base * tx h + ty base * ty h <? 0 end.
Fixpoint build (base : triple) (depth : nat) (l : list corner) : order * list corner :=
  match depth with
  | O => (Tip, l)
  | S depth =>
    let (a, l) := build base depth l in
    match l with
    | [] => (a, [])
    | c :: l => let (b, l) := build base depth l in (Fork a c (is_late base (before c)) b, l)
    end
  end.
Fixpoint seek (h : triple) (late : bool) (t : order) (best : corner) : corner :=
  match t with
  | Tip => best
  | Fork l c c_late r =>
    if (if eqb late c_late then not_right (before c) h else late) then seek h late r c else seek h late l best
  end.

(* The fan of triangles from g0: each is positive, its outer edge is the line of a side, every turn is to the left, and all
   are within half a turn of g1, of which n = g0 x g1 tells. *)
Fixpoint fan (g0 n q r : triple) (rest sides : list triple) : bool :=
  match rest, sides with
  | [], [last] => (dot last r =? 0) && (dot last g0 =? 0) && (0 <? dot last q)
  | s :: rest, h :: sides =>
    let m := cross r s in
    (0 <? dot m g0) && (0 <=? dot m q) && (0 <? dot n s) &&
    (dot h r =? 0) && (dot h s =? 0) && (0 <? dot h g0) && fan g0 n r s rest sides
  | _, _ => false
  end.
Definition fan_of (gs sides : list triple) : bool :=
  match gs, sides with
  | g0 :: g1 :: g2 :: rest, h0 :: sides =>
    (dot h0 g0 =? 0) && (dot h0 g1 =? 0) && (0 <? dot h0 g2) && fan g0 (cross g0 g1) g0 g1 (g2 :: rest) sides
  | _, _ => false
  end.
(* The same without turns, for sets with two opposite directions. *)
Fixpoint cover (g0 q r : triple) (rest sides : list triple) : bool :=
  match rest, sides with
  | [], [last] => (dot last r =? 0) && (dot last g0 =? 0) && (0 <? dot last q)
  | s :: rest, h :: sides =>
    (0 <? det g0 r s) && (dot h r =? 0) && (dot h s =? 0) && (0 <? dot h g0) && cover g0 r s rest sides
  | _, _ => false
  end.
Definition cover_of (gs sides : list triple) : bool :=
  match gs, sides with
  | g0 :: g1 :: g2 :: rest, h0 :: sides =>
    (dot h0 g0 =? 0) && (dot h0 g1 =? 0) && (0 <? dot h0 g2) && cover g0 g0 g1 (g2 :: rest) sides
  | _, _ => false
  end.

Fixpoint corners_from (h : triple) (gs sides : list triple) : list corner :=
  match gs, sides with
  | g :: gs, s :: sides => if 0 <? tw g then Corner h g s :: corners_from s gs sides else corners_from s gs sides
  | _, _ => []
  end.
Definition corners (gs sides : list triple) : list corner :=
  match gs, sides with
  | g0 :: gs, h0 :: sides => corners_from h0 (gs ++ [g0]) (sides ++ [h0])
  | _, _ => []
  end.

(* The generators of a set with a vertex and more than two generators, counterclockwise. *)
Definition arranged (vs rs : list triple) : list triple :=
  match rs with [] => vs | [r] => r :: vs | r :: r' :: _ => r :: vs ++ [r'] end.

Definition parallel (a b : triple) := let c := cross a b in (tx c =? 0) && (ty c =? 0) && (tw c =? 0).
(* p is on the line through g1 and g2 (h, h'), not beyond g1 (e1) and not beyond g2 (e2). *)
Definition on_line (g1 g2 h h' : triple) : bool :=
  let n := cross g1 g2 in parallel h n && parallel h' n && (0 <? dot h n) && (dot h' n <? 0).
Definition between (g1 g2 e1 e2 : triple) : bool :=
  (dot e1 g1 =? 0) && (0 <? dot e1 g2) && (dot e2 g2 =? 0) && (0 <? dot e2 g1).
Definition across (v r : triple) := T (tw v * tx r) (tw v * ty r) (- (tx r * tx v + ty r * ty v)).

Fixpoint pairs (h0 : triple) (l : list triple) : list (triple * triple) :=
  match l with [] => [] | [h] => [(h, h0)] | h :: (h' :: _) as l => (h, h') :: pairs h0 l end.
Definition pinned (v : triple) (sides : list triple) : bool :=
  match sides with
  | [] => false
  | h0 :: _ =>
    let around h := existsb (fun s => is_corner (Corner (fst s) v (snd s)) && enclosed (Corner (fst s) v (snd s)) h) (pairs h0 sides) in
    around (T (tw v) 0 (- tx v)) && around (T (- tw v) 0 (tx v)) &&
    around (T 0 (tw v) (- ty v)) && around (T 0 (- tw v) (ty v))
  end.

(* Which half-planes are the sides, by their numbers; of a polygon in the order of its generators. *)
Inductive certificate :=
  | Polygon (sides : list Z)
  | Strip (sides : list Z)                  (* two vertices, two opposite rays *)
  | HalfPlane (s : Z)                       (* a vertex; rays along, inside, back *)
  | Segment (h h' e1 e2 : Z)                (* two vertices *)
  | Ray (h h' e : Z)                        (* a vertex and a ray *)
  | Line (h h' : Z)                         (* a vertex and two opposite rays *)
  | Pinned (sides : list Z)                 (* one vertex *)
  | Everything.                             (* the origin and four rays *)

Definition all_hold (hs gs : list triple) := forallb (fun h => forallb (fun g => 0 <=? dot h g) gs) hs.

Definition check_polygon (hs gs sides : list triple) : bool :=
  let cs := corners gs sides in
  match cs with
  | [] => false
  | c :: _ =>
    let base := before c in
    let t := fst (build base 40 cs) in
    fan_of gs sides && forallb is_corner cs && forallb (fun h => enclosed (seek h (is_late base h) t c) h) hs
  end.

Definition check (forms : list form) (cert : certificate) (vertices rays : list (Q * Q)) : bool :=
  let hs := flat_map halves forms in
  let vs := map vertex vertices in
  let rs := map ray rays in
  let t := table hs 1 Leaf in
  match cert, vs, rs with
  | Polygon sides, _ :: _, _ => (Z.of_nat (length rs) <=? 2) && check_polygon hs (arranged vs rs) (map (side t) sides)
  | Strip sides, [v; w], [r; r'] => cover_of [v; r; w; r'] (map (side t) sides) && all_hold hs [v; w; r; r']
  | HalfPlane s, [v], [r; n; r'] =>
    cover_of [v; r; n; r'] [side t s; infinity; infinity; side t s] && all_hold hs [v; r; n; r']
  | Segment h h' e1 e2, [v; w], [] =>
    on_line v w (side t h) (side t h') && between v w (side t e1) (side t e2) && all_hold hs [v; w]
  | Ray h h' e, [v], [r] =>
    on_line v r (side t h) (side t h') && between v r (side t e) infinity && all_hold hs [v; r]
  | Line h h', [v], [r; r'] =>
    on_line v r (side t h) (side t h') && between v r (across v r) infinity &&
    on_line v r' (side t h') (side t h) && between v r' (opposite (across v r)) infinity && all_hold hs [v; r; r']
  | Pinned sides, [v], [] => pinned v (map (side t) sides) && all_hold hs [v]
  | Everything, [v], [r1; r2; r3; r4] =>
    is_same v (T 0 0 1) && is_same r1 (T 1 0 0) && is_same r2 (T (-1) 0 0) && is_same r3 (T 0 1 0) && is_same r4 (T 0 (-1) 0) &&
    all_hold hs [v; r1; r2; r3; r4]
  | _, _, _ => false
  end.

(* At most three half-planes that nothing meets; their multipliers follow. *)
Definition times (z : Z) (h : triple) := T (z * tx h) (z * ty h) (z * tw h).
Definition plus (a b : triple) := T (tx a + tx b) (ty a + ty b) (tw a + tw b).
Definition size (h : triple) := Z.abs (tx h) + Z.abs (ty h).
Definition contradict (l : list triple) : bool :=
  let is_wrong h := (tx h =? 0) && (ty h =? 0) && (tw h <? 0) in
  match l with
  | [a] => is_wrong a
  | [a; b] => (0 <=? size a) && is_wrong (plus (times (size b) a) (times (size a) b))
  | [a; b; c] =>
    let '(l, m, n) := (turn b c, turn c a, turn a b) in
    (0 <=? l) && (0 <=? m) && (0 <=? n) && is_wrong (plus (times l a) (plus (times m b) (times n c)))
  | _ => false
  end.
Definition check_empty (forms : list form) (numbers : list Z) : bool :=
  contradict (map (side (table (flat_map halves forms) 1 Leaf)) numbers).
